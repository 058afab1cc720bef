// The field in which the hand presses. One CSS pixel is the same way of the hand on every screen.

const kWidth = 320, kHeight = 480;           // [CSS px]
const kHighestSkin = 96, kLowestSkin = 152;  // between which the skin's line is drawn, from the top [CSS px]
const kMetresPerPixel = 1 / 32000;           // 32 px for a millimetre of press
const kRadius = 15;                          // of the pointer's mark [CSS px]
const kAtRest = -1.5e-3;                     // where the hand waits, above the skin [m]
const kHighest = -2e-3;                      // no higher: there is nothing to feel [m]

/**
 * Draws the skin and the pointer, and tells where the hand is. The browser's own pointer is taken away where it lets
 * us, so that the hand has no end to stop at and nothing on the screen to be measured against; else (a touch screen, a
 * browser that refuses) the place in the field counts, and whoever leaves the field has let go.
 */
export class Field {
  private hand: number | null = null;  // [m], down positive; unknown until the pointer moves
  private depth = kAtRest;             // where the pointer is drawn [m]
  private skin = kHighestSkin;
  private active = false;
  private held: number | null = null;  // the touch or button that holds the pointer to the field

  constructor(private readonly canvas: HTMLCanvasElement) {
    canvas.style.touchAction = "none";
    window.addEventListener("pointermove", (event) => this.follow(event), { passive: true });
    canvas.addEventListener("pointerdown", (event) => this.hold(event));
    for (const name of ["pointerup", "pointercancel"] as const)
      window.addEventListener(name, (event) => this.letGo(event));
    document.addEventListener("pointerlockchange", () => { this.hand = this.locked ? kAtRest : null; });
  }

  /** Where the hand is [m], or null when no pointer has moved yet. */
  get handDepth(): number | null {
    return this.hand;
  }

  get locked(): boolean {
    return document.pointerLockElement === this.canvas;
  }

  get lifted(): boolean {
    return (this.hand ?? kAtRest) <= 0;
  }

  /** A new interval: the skin is elsewhere, so that no place on the screen means the same as before. */
  begin(): void {
    this.active = true;
    this.canvas.classList.add("active");
    this.skin = kHighestSkin + Math.round(Math.random() * (kLowestSkin - kHighestSkin));
    this.canvas.dataset.skin = `${this.skin}`;
    this.hand = this.locked ? kAtRest : null;
    this.depth = kAtRest;
    if (!this.locked) this.lock();
  }

  /** Between intervals the pointer waits, and stays ours. */
  rest(): void {
    this.active = false;
    this.canvas.classList.remove("active");
    this.depth = kAtRest;
  }

  /** The browser's pointer is needed again. */
  release(): void {
    this.rest();
    if (this.locked) document.exitPointerLock();
  }

  place(depth: number): void {
    this.depth = depth;
  }

  draw(): void {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(kWidth * ratio), height = Math.round(kHeight * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    const context = this.canvas.getContext("2d");
    if (!context) return;
    const style = getComputedStyle(this.canvas);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colour("--field-air");
    context.fillRect(0, 0, kWidth, this.skin);
    context.fillStyle = colour("--field-tissue");
    context.fillRect(0, this.skin, kWidth, kHeight - this.skin);
    context.strokeStyle = colour("--field-line");
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(0, this.skin);
    context.lineTo(kWidth, this.skin);
    context.stroke();
    this.drawPointer(context, colour("--field-mark"), colour("--field-edge"));
  }

  private drawPointer(context: CanvasRenderingContext2D, fill: string, edge: string): void {
    const y = this.skin + this.depth / kMetresPerPixel - kRadius;  // its lowest point touches
    context.globalAlpha = this.active ? 1 : 0.45;
    context.fillStyle = fill;
    context.strokeStyle = edge;
    context.lineWidth = 3;
    context.beginPath();
    context.arc(kWidth / 2, y, kRadius, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.globalAlpha = 1;
  }

  private lock(): void {
    if (!window.matchMedia("(pointer: fine)").matches) return;
    const asked: unknown = this.canvas.requestPointerLock?.();
    if (asked instanceof Promise) asked.catch(() => undefined);  // refused: the place in the field counts
  }

  private follow(event: PointerEvent): void {
    if (!this.active) return;
    if (this.locked) {
      this.hand = Math.max((this.hand ?? kAtRest) + event.movementY * kMetresPerPixel, kHighest);
      return;
    }
    const box = this.canvas.getBoundingClientRect();
    const inside = event.clientX >= box.left && event.clientX < box.right &&
                   event.clientY >= box.top && event.clientY < box.bottom;
    if (event.pointerType === "touch" && this.held !== event.pointerId) return;
    this.hand = inside || this.held === event.pointerId
      ? Math.max((event.clientY - box.top - this.skin) * kMetresPerPixel, kHighest)
      : kAtRest;
  }

  private hold(event: PointerEvent): void {
    if (this.locked) return;
    if (event.pointerType === "mouse") this.lock();  // a user's act: what was refused before may be had now
    this.held = event.pointerId;
    this.canvas.setPointerCapture(event.pointerId);
    this.follow(event);
  }

  private letGo(event: PointerEvent): void {
    if (this.held !== event.pointerId) return;
    this.held = null;
    if (event.pointerType === "touch") this.hand = kAtRest;
    else this.follow(event);
  }
}
