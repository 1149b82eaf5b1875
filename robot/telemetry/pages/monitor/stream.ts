// SPDX-License-Identifier: MIT
// The program's events. The browser comes back by itself and says what it got last (Last-Event-ID); where it gives up,
// because the program is gone or full, we begin again.

/** "refused": the program asks for a token that this page has not. */
export type Connection = "connecting" | "live" | "lost" | "refused";

/** Chosen: a program that is started again is found within two breaths. */
const again_ms = 3000;

export function listen(path: string, take: (data: string) => void, changed: (to: Connection) => void): void {
  const source = new EventSource(path);
  source.onopen = () => changed("live");
  source.onmessage = (event: MessageEvent<string>) => take(event.data);
  source.onerror = () => {
    if (source.readyState !== EventSource.CLOSED) {
      changed("lost");
      return;
    }
    // A browser does not say why a stream was refused.
    void fetch("./", { method: "HEAD", credentials: "same-origin" })
      .then((answer) => answer.status === 401, () => false)
      .then((refused) => {
        changed(refused ? "refused" : "lost");
        setTimeout(() => listen(path, take, changed), again_ms);
      });
  };
}
