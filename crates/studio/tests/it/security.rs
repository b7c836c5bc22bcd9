//! Only a page of this server that has the token receives responses, and nothing outside the folder is accessed.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::client::Running;

fn is_alive(studio: &Running) -> bool {
    studio.get(&format!("/?token={}", studio.token)).status == 200
}

#[test]
fn without_the_token_nothing_is_given() {
    let studio = Running::new();
    let before = studio.files();
    let wrong = "0".repeat(studio.token.len());
    let shorter = &studio.token[1..];
    for target in [
        "/".to_string(),
        format!("/?token={wrong}"),
        format!("/?token={shorter}"),
        "/?token=".to_string(),
        format!("/{wrong}/start.json"),
        "/start.json".to_string(),
        "/app.js".to_string(),
        format!("/start.json?token={}x", studio.token),
    ] {
        let answer = studio.get(&target);
        assert_eq!(answer.status, 403, "{target}");
        assert!(!String::from_utf8_lossy(&answer.body).contains(&studio.token));
    }
    assert!(is_alive(&studio));
    assert_eq!(studio.files(), before);
}

#[test]
fn foreign_hosts_and_origins_are_refused() {
    let studio = Running::new();
    let target = format!("/?token={}", studio.token);
    let port = studio.port;
    for host in [
        "evil.example",
        "evil.example:80",
        "127.0.0.1",
        "127.0.0.1:1",
        "127.0.0.1.evil.example",
        "",
    ] {
        assert_eq!(
            studio.ask("GET", &target, host, "", b"").status,
            403,
            "{host}"
        );
    }
    for origin in [
        "http://evil.example",
        "https://127.0.0.1",
        "null",
        "http://127.0.0.1:1",
        "file://",
    ] {
        let more = format!("Origin: {origin}\r\n");
        let own = studio.host();
        assert_eq!(
            studio.ask("GET", &target, &own, &more, b"").status,
            403,
            "{origin}"
        );
    }
    let twice = format!("Host: localhost:{port}\r\n");
    assert_eq!(
        studio
            .ask("GET", &target, &studio.host(), &twice, b"")
            .status,
        403
    );
    for (host, more) in [
        (studio.host(), String::new()),
        (
            format!("localhost:{port}"),
            format!("Origin: http://localhost:{port}\r\n"),
        ),
        (
            studio.host(),
            format!("Origin: http://127.0.0.1:{port}\r\n"),
        ),
    ] {
        assert_eq!(
            studio.ask("GET", &target, &host, &more, b"").status,
            200,
            "{host} {more}"
        );
    }
}

#[test]
fn no_path_leads_out_of_the_folder() {
    let studio = Running::new();
    std::fs::write(studio.inside().join("own.toml"), "name = \"own\"\n").unwrap();
    let before = studio.files();
    let token = &studio.token;
    for path in [
        "folder/../secret.toml",
        "folder/%2e%2e/secret.toml",
        "folder/..%2fsecret.toml",
        "folder/x/../../secret.toml",
        "folder/..\\secret.toml",
        "../../etc/passwd",
        "%2e%2e/%2e%2e/etc/passwd",
        "folder/own.toml%00.png",
    ] {
        let answer = studio.get(&format!("/{token}/{path}"));
        assert_eq!(answer.status, 403, "{path}");
        assert_eq!(
            studio.get(&format!("/{path}?token={token}")).status,
            403,
            "{path}"
        );
    }
    let own = studio.get(&format!("/{token}/folder/own.toml")).json();
    assert_eq!(own["scene"], "name = \"own\"\n");
    for path in ["folder//etc/passwd", "folder/nothing.toml"] {
        let answer = studio.get(&format!("/{token}/{path}"));
        assert!(answer.json()["error"]["code"].is_string(), "{path}");
    }
    for file in ["../secret.toml", "/etc/passwd", "a/../../secret.toml"] {
        let scene = format!("[gait]\nfile = \"{file}\"\n");
        let body = serde_json::json!({"scene": scene}).to_string();
        let answer = studio.post("design", body.as_bytes()).json();
        assert_eq!(
            answer["error"]["code"], "studio-outside",
            "{file}: {answer}"
        );
    }
    for name in ["../out.toml", "/tmp/out.toml", "a/b.toml", ".hidden", ""] {
        let body = serde_json::json!({"scene": "", "name": name}).to_string();
        let answer = studio.post("save", body.as_bytes()).json();
        assert_eq!(
            answer["error"]["code"], "studio-file-name",
            "{name}: {answer}"
        );
    }
    assert_eq!(studio.files(), before);
}

#[test]
fn large_bodies_are_refused_before_they_are_read() {
    let studio = Running::new();
    let before = studio.files();
    let piece = vec![b'x'; 1 << 20];
    for (target, status) in [
        (format!("/{}/keep", studio.token), "413"),
        (format!("/{}/design", studio.token), "413"),
        ("/keep".to_string(), "403"),
    ] {
        let start = Instant::now();
        let mut stream = TcpStream::connect(("127.0.0.1", studio.port)).unwrap();
        let host = studio.host();
        let head = format!(
            "POST {target} HTTP/1.1\r\nHost: {host}\r\nContent-Length: {}\r\n\r\n",
            100 << 20
        );
        stream.write_all(head.as_bytes()).unwrap();
        for _ in 0..100 {
            if stream.write_all(&piece).is_err() {
                break;
            }
        }
        let mut answer = [0; 12];
        stream.read_exact(&mut answer).unwrap();
        assert_eq!(
            std::str::from_utf8(&answer[9..]).unwrap(),
            status,
            "{target}"
        );
        assert!(start.elapsed() < Duration::from_secs(20));
    }
    assert!(is_alive(&studio));
    assert_eq!(studio.files(), before);
}

#[test]
fn nonsense_is_refused_and_harms_nothing() {
    let studio = Running::new();
    let before = studio.files();
    for body in [
        "",
        "{",
        "[]",
        "null",
        "\0\0",
        "{\"scene\": 4}",
        "{\"scene\": \"\", \"more\": 1}",
        "{\"scene\": \"\", \"changes\": [{\"delete\": {}}]}",
    ] {
        let answer = studio.post("design", body.as_bytes());
        assert_eq!(answer.status, 400, "{body}");
        assert_eq!(answer.json()["error"]["code"], "studio-bad-request");
    }
    let deep = format!("{{\"scene\": {}", "[".repeat(100_000));
    assert_eq!(studio.post("design", deep.as_bytes()).status, 400);
    for scene in [
        "name = ",
        "[cam",
        &format!("x = {}", "[".repeat(100_000)),
        "\u{0}",
    ] {
        let body = serde_json::json!({"scene": scene}).to_string();
        let answer = studio.post("design", body.as_bytes());
        assert_eq!(answer.json()["error"]["code"], "studio-not-toml");
    }
    for head in [
        "\r\n\r\n".to_string(),
        "GET\r\n\r\n".to_string(),
        "BREW / HTTP/1.1\r\n\r\n".to_string(),
        format!("GET /{} HTTP/1.1\r\n\r\n", "a".repeat(40_000)),
        format!("GET / HTTP/1.1\r\n{}\r\n", "X: y\r\n".repeat(3_000)),
        "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n".to_string(),
        "POST / HTTP/1.1\r\nContent-Length: 99999999999999999999\r\n\r\n".to_string(),
    ] {
        if let Some(answer) = studio.raw(head.as_bytes()) {
            assert!(
                (400..=431).contains(&answer.status),
                "{}: {}",
                answer.status,
                answer.head
            );
        }
    }
    assert!(is_alive(&studio));
    assert_eq!(studio.files(), before);
}

#[test]
fn a_thousand_connections_leave_it_alive() {
    let studio = Running::new();
    let before = studio.files();
    let open: Vec<_> = (0..1000)
        .filter_map(|_| TcpStream::connect(("127.0.0.1", studio.port)).ok())
        .collect();
    assert!(open.len() > 500, "only {} connections", open.len());
    drop(open);
    let deadline = Instant::now() + Duration::from_secs(20);
    while !is_alive(&studio) {
        assert!(Instant::now() < deadline);
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(studio.files(), before);
}

#[test]
fn connections_that_ask_nothing_keep_no_page_waiting() {
    let studio = Running::new();
    let (host, token) = (studio.host(), &studio.token);
    let answered = format!("GET /{token}/folder.json HTTP/1.1\r\nHost: {host}\r\n\r\n");
    for begun in ["", "GET / HTTP/1.1\r\nHo", &answered] {
        let connect = |_| {
            let mut stream = TcpStream::connect(("127.0.0.1", studio.port)).unwrap();
            stream.write_all(begun.as_bytes()).unwrap();
            if begun.len() > 30 {
                let mut status = [0; 12];
                stream.read_exact(&mut status).unwrap();
                assert_eq!(&status, b"HTTP/1.1 200");
            }
            stream
        };
        let open: Vec<TcpStream> = (0..120).map(connect).collect();
        let start = Instant::now();
        for _ in 0..8 {
            assert!(is_alive(&studio), "{begun:?}");
        }
        assert!(start.elapsed() < Duration::from_secs(5), "{begun:?}");
        drop(open);
    }
}

#[test]
fn a_head_that_does_not_end_is_given_up_soon() {
    let studio = Running::new();
    let mut stream = TcpStream::connect(("127.0.0.1", studio.port)).unwrap();
    let start = Instant::now();
    let patience = Some(Duration::from_secs(15));
    stream.set_read_timeout(patience).unwrap();
    stream.write_all(b"GET / HTTP/1.1\r\nHo").unwrap();
    assert_eq!(stream.read(&mut [0]).unwrap(), 0);
    assert!(start.elapsed() < Duration::from_secs(10));
}

#[test]
fn answers_may_not_be_framed_guessed_or_kept() {
    let studio = Running::new();
    let page = studio.get(&format!("/?token={}", studio.token));
    for header in [
        "X-Content-Type-Options: nosniff",
        "Referrer-Policy: no-referrer",
        "Cache-Control: no-store",
        "frame-ancestors 'none'",
        "script-src 'self'",
    ] {
        assert!(
            page.head.contains(header),
            "{header} is missing in {}",
            page.head
        );
    }
    assert!(!page.head.contains("Access-Control"));
}
