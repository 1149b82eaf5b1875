// SPDX-License-Identifier: MIT
// The document with everything that it was before. Each change works on a copy, so what was drawn stays as it was.
import type { Doc } from "./model";

interface Step {
  label: string;
  before: Doc;
}
/** Chosen: an afternoon's strokes; a document of a hundred places takes some 50 kB. */
const mostSteps = 300;

export class History {
  private now: Doc;
  private past: Step[] = [];
  private future: Step[] = [];
  private merging: string | null = null;
  private savedDoc: Doc;
  private readonly listeners: (() => void)[] = [];

  constructor(doc: Doc) {
    this.now = doc;
    this.savedDoc = doc;
  }

  get doc(): Doc {
    return this.now;
  }
  get undoable(): string | null {
    return this.past.at(-1)?.label ?? null;
  }
  get redoable(): string | null {
    return this.future.at(-1)?.label ?? null;
  }
  get changed(): boolean {
    return this.now !== this.savedDoc;
  }
  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /**
   * Changes a copy. Changes of the same `merge` key that follow each other are one step of undo: a drag, a word being
   * typed. \returns what `edit` returns
   */
  change<T>(label: string, edit: (draft: Doc) => T, merge: string | null = null): T {
    const draft = structuredClone(this.now);
    const result = edit(draft);
    if (merge === null || merge !== this.merging) {
      this.past.push({ label, before: this.now });
      this.past.splice(0, this.past.length - mostSteps);
    }
    this.merging = merge;
    this.future = [];
    this.now = draft;
    this.tell();
    return result;
  }
  /** What comes next is a step of its own. */
  endMerge(): void {
    this.merging = null;
  }
  undo(): string | null {
    return this.shift(this.past, this.future);
  }
  redo(): string | null {
    return this.shift(this.future, this.past);
  }
  /** Another document, without a past. */
  reset(doc: Doc): void {
    this.now = doc;
    this.savedDoc = doc;
    this.past = [];
    this.future = [];
    this.merging = null;
    this.tell();
  }
  saved(doc: Doc): void {
    this.savedDoc = doc;
    this.tell();
  }

  private shift(from: Step[], to: Step[]): string | null {
    const last = from.pop();
    if (!last) {
      return null;
    }
    to.push({ label: last.label, before: this.now });
    this.now = last.before;
    this.merging = null;
    this.tell();
    return last.label;
  }
  private tell(): void {
    for (const listener of this.listeners) {
      listener();
    }
  }
}
