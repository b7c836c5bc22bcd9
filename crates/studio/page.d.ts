// What the page in one file defines for its scripts.
interface Window {
  gaitcamPage?: string;
}
