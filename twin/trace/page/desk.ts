// SPDX-License-Identifier: MIT
// Opening and saving: between the editor and the folder on the server's disk.
import * as api from "./api";
import { askLeave, askOpen, askOverwrite } from "./dialogs";
import type { Editor } from "./editor";
import { docJson, readDoc, readHallways } from "./files";
import { emptyDoc, type Doc } from "./model";
import { planBox } from "./picture";

export class Desk {
  folder = "";
  constructor(private readonly editor: Editor) {}

  async begin(): Promise<void> {
    const session = await api.session();
    this.folder = session.folder;
    this.rename(session.name);
    if (session.opened) {
      this.take(session.opened);
      this.rename(session.name);
    }
    if (session.hallways_file) {
      this.editor.naming.hallways_file = session.hallways_file;
    }
    this.fit();
    this.editor.soonCheck();
  }

  /** Files are called after this name; a hallway map that was opened by itself keeps its own. */
  rename(name: string): void {
    const { naming } = this.editor;
    if (naming.hallways_file === `${naming.name}.hallways.yaml`) {
      naming.hallways_file = `${name}.hallways.yaml`;
    }
    naming.name = name;
  }

  /** A picture goes under what is drawn already, when that has none yet or one of the same size. */
  private goesUnder(opened: api.Opened): boolean {
    const { doc } = this.editor;
    const plan = opened.plan;
    const fits = doc.plan === null || (doc.plan.width_px === plan?.width_px && doc.plan.height_px === plan.height_px);
    return plan !== undefined && doc.places.length > 0 && fits;
  }
  private take(opened: api.Opened): void {
    const { editor } = this;
    const said: string[] = [];
    if (opened.plan && this.goesUnder(opened)) {
      const plan = opened.plan;
      editor.history.change("plan", (draft) => {
        draft.plan = draft.plan ? { ...draft.plan, id: plan.id } : plan;
      });
      said.push(`${plan.name} lies under the drawing.`);
    } else if (opened.plan) {
      const plan = opened.plan;
      const doc: Doc = { ...emptyDoc(), plan };
      doc.scene.walls = "plan";
      editor.history.reset(doc);
      this.rename(opened.name);
      said.push(
        plan.scaled
          ? `${plan.name} is ${(plan.width_px * plan.resolution_m).toFixed(1)} m wide.`
          : `${plan.name} has no scale yet: take the Scale tool (S).`,
      );
    } else {
      const read = opened.document ? readDoc(opened.document) : this.fromHallways(opened.hallways ?? {});
      editor.history.reset(read.doc);
      editor.naming = { name: opened.name, hallways_file: opened.hallways_file ?? `${opened.name}.hallways.yaml` };
      editor.stamps = opened.stamps ?? {};
      said.push(`${opened.name}: ${read.doc.places.length} places.`);
      if (read.guessed) {
        said.push("Places had no positions; they were laid out by the hallways.");
      }
    }
    editor.forget();
    editor.say([...said, opened.note ?? ""].join(" ").trim());
  }
  private fromHallways(hallways: Record<string, unknown>): { doc: Doc; guessed: boolean } {
    const doc = emptyDoc();
    return { doc, ...readHallways(doc, hallways) };
  }

  async open(): Promise<void> {
    try {
      const session = await api.session();
      const chosen = await askOpen(session.folder, session.files);
      if (chosen === null) {
        return;
      }
      if ("name" in chosen && chosen.name === "") {
        await this.show(null);
      } else {
        await this.show("file" in chosen ? await api.upload(chosen.file) : await api.open(chosen.name));
      }
    } catch (error) {
      this.editor.say((error as Error).message, "bad");
    }
  }
  async openPicture(file: File): Promise<void> {
    try {
      await this.show(await api.upload(file));
    } catch (error) {
      this.editor.say((error as Error).message, "bad");
    }
  }
  /** Instead of what is drawn, or under it. \param opened  null: an empty sheet */
  private async show(opened: api.Opened | null): Promise<void> {
    const replaces = opened === null || !this.goesUnder(opened);
    if (replaces && this.editor.history.changed && !(await askLeave())) {
      return;
    }
    if (opened) {
      this.take(opened);
    } else {
      this.editor.history.reset(emptyDoc());
      this.editor.stamps = {};
      this.editor.forget();
    }
    this.fit();
  }

  async save(scene: boolean, overwrite = false): Promise<void> {
    const { editor } = this;
    const doc = editor.doc;
    try {
      const answer = await api.save(docJson(doc), editor.naming, { scene, overwrite, stamps: editor.stamps });
      if (answer.conflicts) {
        const how = await askOverwrite(answer.conflicts);
        if (how === "overwrite") {
          await this.save(scene, true);
        } else if (how === "reload") {
          this.take(
            await api.open(
              answer.conflicts.find((name) => name.endsWith(".trace.json")) ?? (answer.conflicts[0] as string),
            ),
          );
          this.fit();
        } else {
          editor.say("Nothing was saved.");
        }
        return;
      }
      if (answer.refused) {
        editor.sceneProblems = answer.problems ?? [];
        editor.say(`Not saved: ${answer.refused}.`, "bad");
        editor.changed();
        return;
      }
      editor.stamps = { ...editor.stamps, ...answer.stamps };
      editor.history.saved(doc);
      const names = Object.keys(answer.stamps ?? {}).join(", ");
      editor.say(
        answer.draft
          ? `Saved as a draft (${names}): the hallway map has mistakes, and the robot's file stays as it was.`
          : `Saved ${names}.`,
        answer.draft ? "bad" : "info",
      );
    } catch (error) {
      editor.say((error as Error).message, "bad");
    }
  }

  /** Everything there is, on the screen. */
  fit(): void {
    const { doc, view } = this.editor;
    const points = [
      ...doc.places.map((place) => place.at),
      ...doc.scene.room,
      ...doc.scene.ceiling.map((tag) => tag.at),
      ...(doc.scene.region ?? []),
    ];
    const boxes = doc.plan ? [planBox(doc.plan)] : [];
    const xs = [...points.map((p) => p.x), ...boxes.flatMap((box) => [box.low.x, box.high.x])];
    const ys = [...points.map((p) => p.y), ...boxes.flatMap((box) => [box.low.y, box.high.y])];
    const margin = doc.plan ? 0 : 2;
    view?.fit(
      xs.length === 0
        ? { low: { x: -3, y: -14 }, high: { x: 27, y: 4 } }
        : {
            low: { x: Math.min(...xs) - margin, y: Math.min(...ys) - margin },
            high: { x: Math.max(...xs) + margin, y: Math.max(...ys) + margin },
          },
    );
    this.editor.changed();
  }
}
