// The field in which the hand presses. One CSS pixel is the same way of the hand on every screen.

const kWidth = 320, kHeight = 480;  // [CSS px]
const kSkin = 96;                   // the skin's line, from the top [CSS px]
const kMetresPerPixel = 1 / 32000;  // 32 px for a millimetre of press
const kRadius = 15;                 // of the pointer's mark [CSS px]

/** Draws the skin and the pointer, and tells where the hand is. */
export class Field {
  private hand: number | null = null;  // [m], down positive; unknown until the pointer moves
  private depth = -1e-3;               // where the pointer is drawn [m]
  private active = false;

  constructor(private readonly canvas: HTMLCanvasElement) {
    canvas.style.touchAction = "none";
    const follow = (event: PointerEvent) => this.follow(event);
    window.addEventListener("pointermove", follow, { passive: true });
    window.addEventListener("pointerdown", follow, { passive: true });
  }

  /** Where the hand is [m], or null when no pointer has moved yet. */
  get handDepth(): number | null {
    return this.hand;
  }

  /** A phase without pressing shows the pointer at rest. */
  setActive(active: boolean): void {
    this.active = active;
    this.canvas.classList.toggle("active", active);
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
    context.fillRect(0, 0, kWidth, kSkin);
    context.fillStyle = colour("--field-tissue");
    context.fillRect(0, kSkin, kWidth, kHeight - kSkin);
    context.strokeStyle = colour("--field-line");
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(0, kSkin);
    context.lineTo(kWidth, kSkin);
    context.stroke();
    this.drawPointer(context, colour("--field-mark"), colour("--field-edge"));
  }

  private drawPointer(context: CanvasRenderingContext2D, fill: string, edge: string): void {
    const y = kSkin + this.depth / kMetresPerPixel - kRadius;  // its lowest point touches
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

  private follow(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    if (box.height === 0) return;
    const y = Math.min(Math.max(event.clientY - box.top, 0), kHeight);
    this.hand = (y - kSkin) * kMetresPerPixel;
  }
}
