// What page and server say to each other; messages.hpp is the other half.

export type PhaseName =
  | "welcome" | "gesture" | "ready" | "interval" | "pause" | "again" | "question" | "feedback" | "thanks" | "end"
  | "fault";

/** One answer that is offered, and the keys that give it. */
export interface Choice {
  label: string;
  keys: string[];
}

/** What is said of an answer once it is saved. */
export interface Feedback {
  right: boolean;
  answer: number;  // that was the right one, from 1
}

/** The server decides what is shown; the page holds no state of the session. */
export interface Phase {
  type: "phase";
  id: number;  // of this showing; replies carry it, so that a late reply answers nothing else
  phase: PhaseName;
  interval: number;
  intervals: number;
  number: number;     // of the question, from 1; 0 when all are answered
  questions: number;
  minutes: number;    // that they take, about
  question: string;
  run_mode: "study" | "pilot" | "practice";
  pseudo_haptic: boolean;
  picture: boolean;  // whether frames of the organs come
  notice: string;    // a sentence to show first; often empty
  presses: [number, number];
  choices: Choice[];    // what can be answered: answer k is choices[k - 1]
  hint: string;         // how to answer
  spoken_hint: string;  // the same, for a screen reader
  gives_feedback?: boolean;  // whether this study says after each answer if it was right
  feedback?: Feedback;       // in the phase "feedback" alone
}

export interface Probe {
  begun: boolean;
  mayFinish: boolean;
  over: boolean;
  deepEnough: boolean;
  presses: number;      // begun so far
  secondsLeft: number;  // at most 255
  depth: number;        // of the pointer [m]
}

export type Reply =
  | { type: "continue" | "finish"; id: number }
  | { type: "answer"; id: number; choice: number; ms: number }
  | { type: "early"; id: number; key: string }
  | { type: "strategy"; id: number; text: string };

const kHand = 1, kProbe = 2, kFrame = 3;

/** The hand's depth in micrometres: the same number of bytes whatever it is. */
export function encodeHand(id: number, depth: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(12));
  view.setUint8(0, kHand);
  view.setUint32(4, id, true);
  view.setInt32(8, Math.round(depth * 1e6), true);
  return view.buffer;
}

export function decodeBinary(data: ArrayBuffer): { probe?: Probe; frame?: Blob } {
  const view = new DataView(data);
  if (view.byteLength === 12 && view.getUint8(0) === kProbe) {
    const flags = view.getUint8(1);
    return {
      probe: {
        begun: (flags & 1) !== 0,
        mayFinish: (flags & 2) !== 0,
        over: (flags & 4) !== 0,
        deepEnough: (flags & 8) !== 0,
        presses: view.getUint8(2),
        secondsLeft: view.getUint8(3),
        depth: view.getInt32(8, true) * 1e-6,
      },
    };
  }
  if (view.byteLength > 1 && view.getUint8(0) === kFrame)
    return { frame: new Blob([new Uint8Array(data, 1)], { type: "image/jpeg" }) };
  return {};
}
