export interface Listener {
  text(message: string): void;
  binary(message: ArrayBuffer): void;
  lost(): void;
  takenOver(): void;
}

const kTakenOver = 4001;  // close code: the link was opened in another window
const kEnded = 4000;      // close code: the session is over
const kRetryAfter = 1000;  // [ms]

/** A page's one connection to the server; comes back by itself when it is lost. Sends messages of type Reply. */
export class Link<Reply extends object> {
  private socket: WebSocket | null = null;
  private closed = false;

  constructor(private readonly listener: Listener) {
    this.open();
  }

  send(message: Reply): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  sendBinary(data: ArrayBuffer): void {
    const socket = this.socket;
    // A hand sample that cannot leave at once is worth nothing later.
    if (socket?.readyState === WebSocket.OPEN && socket.bufferedAmount < 1024) socket.send(data);
  }

  private open(): void {
    const socket = new WebSocket(new URL("live", location.href).href.replace(/^http/, "ws"));
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event: MessageEvent) => this.receive(event.data);
    socket.onclose = (event: CloseEvent) => this.gone(event.code);
    this.socket = socket;
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data === "string") this.listener.text(data);
    else this.listener.binary(data);
  }

  private gone(code: number): void {
    if (this.closed) return;
    if (code === kTakenOver || code === kEnded) {
      this.closed = true;
      if (code === kTakenOver) this.listener.takenOver();
      return;
    }
    this.listener.lost();
    setTimeout(() => this.open(), kRetryAfter);
  }
}
