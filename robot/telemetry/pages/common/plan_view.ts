// SPDX-License-Identifier: MIT
// A plan on a canvas that is moved and magnified by mouse, touch and keys. Plan coordinates: metres, x to the right, y
// up. Screen coordinates: CSS pixels of the canvas, y down.

export interface Point {
  x: number;
  y: number;
}
export interface Box {
  low: Point;
  high: Point;
}

/** Scales in pixels a metre. Chosen: a street on a phone, a tag on a desk. */
const leastScale = 2;
const mostScale = 2000;
/** Of the canvas, left free round what is shown. */
const margin = 0.03;
/** A press that moved less is a click: a finger trembles so much (CSS pixels). */
const clickSlop = 6;

export interface PlanViewHandlers {
  /** Draws everything; `context` is in CSS pixels. */
  draw(context: CanvasRenderingContext2D, view: PlanView): void;
  /** Pointer over the plan, or null when it left. */
  hover?(at: Point | null): void;
  click?(at: Point, event: PointerEvent): void;
  /** A press begins here. True: the handler takes the drag, and the plan does not move. */
  grab?(at: Point, event: PointerEvent): boolean;
  drag?(at: Point, event: PointerEvent): void;
  drop?(at: Point, event: PointerEvent): void;
}

export class PlanView {
  readonly canvas: HTMLCanvasElement;
  private readonly handlers: PlanViewHandlers;
  private readonly context: CanvasRenderingContext2D;
  private centre: Point = { x: 0, y: 0 };
  private scale_ = 50;
  private asked = false;
  private readonly pointers = new Map<number, Point>();
  private pressed: Point | null = null;
  private moved = false;
  private grabbed = false;
  private touched_ = false;

  constructor(canvas: HTMLCanvasElement, handlers: PlanViewHandlers) {
    const context = canvas.getContext("2d");
    if (!context) {
      throw new Error("this browser draws no canvas");
    }
    this.canvas = canvas;
    this.handlers = handlers;
    this.context = context;
    canvas.style.touchAction = "none";
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.up(event));
    canvas.addEventListener("pointerleave", () => this.handlers.hover?.(null));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  get width(): number {
    return this.canvas.clientWidth;
  }
  get height(): number {
    return this.canvas.clientHeight;
  }
  /** Pixels a metre. */
  get scale(): number {
    return this.scale_;
  }
  /** The person has moved or magnified it since the last fit(). */
  get touched(): boolean {
    return this.touched_;
  }

  toScreen(p: Point): Point {
    return {
      x: this.width / 2 + (p.x - this.centre.x) * this.scale_,
      y: this.height / 2 - (p.y - this.centre.y) * this.scale_,
    };
  }
  toPlan(p: Point): Point {
    return {
      x: this.centre.x + (p.x - this.width / 2) / this.scale_,
      y: this.centre.y - (p.y - this.height / 2) / this.scale_,
    };
  }

  /** Draws again before the next frame, once however often it is asked. */
  redraw(): void {
    if (this.asked) {
      return;
    }
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      const ratio = this.canvas.width / Math.max(this.width, 1);
      this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
      this.context.clearRect(0, 0, this.width, this.height);
      this.handlers.draw(this.context, this);
    });
  }

  /** Shows the whole of a box, clear of what stands on the canvas at its top and bottom (pixels). */
  fit(box: Box, top = 0, bottom = 0): void {
    const wide = Math.max(box.high.x - box.low.x, 0.5);
    const high = Math.max(box.high.y - box.low.y, 0.5);
    const free = Math.max(this.height - top - bottom, 50);
    this.setScale(Math.min((this.width * (1 - 2 * margin)) / wide, (free * (1 - 2 * margin)) / high));
    this.centre = {
      x: (box.low.x + box.high.x) / 2,
      y: (box.low.y + box.high.y) / 2 + (top - bottom) / 2 / this.scale_,
    };
    this.touched_ = false;
    this.redraw();
  }

  /** Magnifies so that the plan under `at` (screen) stays there. */
  zoom(factor: number, at: Point = { x: this.width / 2, y: this.height / 2 }): void {
    const before = this.toPlan(at);
    this.setScale(this.scale_ * factor);
    const after = this.toPlan(at);
    this.centre = { x: this.centre.x + before.x - after.x, y: this.centre.y + before.y - after.y };
    this.touched_ = true;
    this.redraw();
  }

  /** Moves the plan by screen pixels. */
  pan(dx: number, dy: number): void {
    this.centre = { x: this.centre.x - dx / this.scale_, y: this.centre.y + dy / this.scale_ };
    this.touched_ = true;
    this.redraw();
  }

  private setScale(scale: number): void {
    this.scale_ = Math.min(Math.max(scale, leastScale), mostScale);
  }

  private resize(): void {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(this.width * ratio);
    const height = Math.round(this.height * ratio);
    if (width !== this.canvas.width || height !== this.canvas.height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.redraw();
  }

  private at(event: PointerEvent | WheelEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    const at = this.at(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, at);
    if (this.pointers.size === 1) {
      this.pressed = at;
      this.moved = false;
      this.grabbed = this.handlers.grab?.(this.toPlan(at), event) ?? false;
    } else {
      this.moved = true;  // two fingers never click
    }
  }

  private move(event: PointerEvent): void {
    const at = this.at(event);
    const last = this.pointers.get(event.pointerId);
    if (!last) {
      this.handlers.hover?.(this.toPlan(at));
      return;
    }
    if (this.pointers.size === 1 && this.pressed) {
      this.moved ||= Math.hypot(at.x - this.pressed.x, at.y - this.pressed.y) > clickSlop;
      if (this.grabbed) {
        this.handlers.drag?.(this.toPlan(at), event);
      } else if (this.moved) {
        this.pan(at.x - last.x, at.y - last.y);
      } else {
        return;
      }
    } else if (this.pointers.size === 2) {
      this.pinch(event.pointerId, last, at);
    }
    this.pointers.set(event.pointerId, at);
  }

  private pinch(moving: number, last: Point, at: Point): void {
    const other = [...this.pointers].find(([id]) => id !== moving)?.[1];
    if (!other) {
      return;
    }
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(at.x - other.x, at.y - other.y);
    this.pan((at.x - last.x) / 2, (at.y - last.y) / 2);
    if (before > 1 && after > 1) {
      this.zoom(after / before, { x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 });
    }
  }

  private up(event: PointerEvent): void {
    const at = this.at(event);
    if (!this.pointers.delete(event.pointerId)) {
      return;
    }
    if (this.pointers.size === 0) {
      if (this.grabbed) {
        this.handlers.drop?.(this.toPlan(at), event);
      }
      if (!this.moved && event.type === "pointerup") {
        this.handlers.click?.(this.toPlan(at), event);
      }
      this.grabbed = false;
      this.pressed = null;
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    // Lines and pages in pixels, as browsers scroll them.
    const unit = event.deltaMode === 0 ? 1 : event.deltaMode === 1 ? 16 : 400;
    this.zoom(Math.exp((-event.deltaY * unit) / 500), this.at(event));
  }

  private key(event: KeyboardEvent): void {
    const step = 40;
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [step, 0],
      ArrowRight: [-step, 0],
      ArrowUp: [0, step],
      ArrowDown: [0, -step],
    };
    const by = moves[event.key];
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    if (by) {
      this.pan(by[0], by[1]);
    } else if (event.key === "+" || event.key === "=") {
      this.zoom(1.25);
    } else if (event.key === "-") {
      this.zoom(0.8);
    } else {
      return;
    }
    event.preventDefault();
  }
}
