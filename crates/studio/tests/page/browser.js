// What the core modules read of a browser while they load.

globalThis.document ??= { documentElement: { lang: "en", dataset: {} } };
globalThis.location ??= { hash: "", search: "" };
