// SPDX-License-Identifier: MIT
// The program's events. The browser comes back by itself and says what it got last (Last-Event-ID); where it gives up,
// because the program is gone or full, we begin again.

export type Connection = "connecting" | "live" | "lost";

/** Chosen: a program that is started again is found within two breaths. */
const again_ms = 3000;

export function listen(path: string, take: (data: string) => void, changed: (to: Connection) => void): void {
  changed("connecting");
  const source = new EventSource(path);
  source.onopen = () => changed("live");
  source.onmessage = (event: MessageEvent<string>) => take(event.data);
  source.onerror = () => {
    changed("lost");
    if (source.readyState === EventSource.CLOSED) {
      source.close();
      setTimeout(() => listen(path, take, changed), again_ms);
    }
  };
}
