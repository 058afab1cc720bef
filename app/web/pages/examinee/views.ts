// What each phase says. Plain words: an examinee reads them for the first time.

import { Feedback, Phase } from "./messages";

export interface Action {
  label: string;
  aside?: string;  // under the label, small
  key: string;     // as it is shown to the examinee
  primary: boolean;
  does: "continue" | "finish" | "answer" | "strategy";
  choice?: number;
}

export interface View {
  title: string;
  paragraphs: string[];
  list?: string[];
  hint?: string;
  stage: boolean;   // whether the field is what to look at
  spoken: string;   // for the live region
  actions: Action[];
}

const ordinals = ["", "first", "second", "third", "fourth"];
const counts = ["", "one", "two", "three", "four"];
const touch = window.matchMedia("(pointer: coarse)").matches;
const hand = touch ? "your finger on the field" : "the mouse";

function nextButton(label: string): Action {
  return { label, key: touch ? "" : "Space", primary: true, does: "continue" };
}

function capital(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** An interval as an examinee knows it: "second turn". */
function turn(interval: number): string {
  return `${ordinals[interval] ?? `${interval}th`} turn`;
}

/** "interval 2" where the study's question speaks of intervals, so that nobody must have been told what that is. */
function asInterval(phase: Phase, interval: number): string {
  return phase.intervals > 1 && /\binterval/i.test(phase.question) ? `interval ${interval}` : "";
}

function turnTitle(phase: Phase): string {
  const aside = asInterval(phase, phase.interval);
  return capital(turn(phase.interval)) + (aside ? ` (${aside})` : "");
}

function times(presses: [number, number]): string {
  const [least, most] = presses;
  if (least === most) return least === 1 ? "once" : `${least} times`;
  return `${least} to ${most} times`;
}

function welcome(phase: Phase): View {
  const paragraphs = [
    "This is a study of a simulation, not of you. Take your time; you can stop whenever you like.",
  ];
  if (phase.pseudo_haptic)
    paragraphs.push(
      "You will not feel a force. The pointer lags behind your hand where the tissue resists: " +
      "the more it resists, the further the pointer stays behind.");
  paragraphs.push(phase.questions === 1 ? "There is one question." :
    `There are ${phase.questions} questions; they take about ${phase.minutes} ${phase.minutes === 1 ? "minute" : "minutes"}.`);
  return {
    title: "Welcome",
    paragraphs,
    list: [
      "First you practise the movement.",
      phase.intervals === 1
        ? "Then you press on a tissue for a short time."
        : `Then you press on a tissue in ${counts[phase.intervals] ?? phase.intervals} turns, one after the other. ` +
          "A turn is a short time in which you may press.",
      `After that you answer one question: “${phase.question}” If you are not sure, go with your impression.`,
      ...(phase.gives_feedback
        ? ["Each time you are told whether you were right. That helps you find out what to go by."]
        : []),
    ],
    stage: false,
    spoken: "Welcome.",
    actions: [nextButton("I understand, begin")],
  };
}

function gesture(): View {
  return {
    title: "Practise the movement",
    paragraphs: [
      `Move ${hand} down to press, up to let go. The line is the skin; the round pointer is your fingertip.`,
    ],
    hint: "Try it out: nothing is counted here.",
    stage: true,
    spoken: `Practise the movement. Move ${hand} down to press, and up to let go.`,
    actions: [nextButton("I am ready")],
  };
}

function ready(phase: Phase): View {
  return {
    title: "Ready?",
    paragraphs: [
      phase.intervals === 1
        ? `Press ${times(phase.presses)}, clearly and deeply.`
        : `You have ${counts[phase.intervals] ?? phase.intervals} turns, one after the other. ` +
          `In each turn press ${times(phase.presses)}, clearly and deeply.`,
      "Rest here as long as you like.",
    ],
    stage: false,
    spoken: "Ready? Start when you like.",
    actions: [nextButton("Start")],
  };
}

function interval(phase: Phase): View {
  return {
    title: phase.intervals === 1 ? "Press now" : turnTitle(phase),
    paragraphs: [],
    stage: true,
    spoken: phase.intervals === 1 ? "Press now." : `${capital(turn(phase.interval))}. Press now.`,
    actions: [{ label: "That is enough", key: touch ? "" : "Space", primary: false, does: "finish" }],
  };
}

function pause(phase: Phase): View {
  return {
    title: phase.interval > 1 ? `Your ${turn(phase.interval)} follows` : "Here it comes",
    paragraphs: ["One moment."],
    stage: true,
    spoken: "A short pause.",
    actions: [],
  };
}

function again(phase: Phase): View {
  return {
    title: phase.intervals === 1 ? "Once more" : `Your ${turn(phase.interval)} once more`,
    paragraphs: ["That is quite all right."],
    stage: false,
    spoken: phase.intervals === 1 ? "Once more." : `Your ${turn(phase.interval)} comes once more.`,
    actions: [nextButton("Press again")],
  };
}

function question(phase: Phase): View {
  return {
    title: phase.question,
    paragraphs: [],
    hint: touch ? "Tap your answer." : phase.hint,
    stage: false,
    spoken: `${phase.question} ${phase.spoken_hint}`,
    actions: phase.choices.map((choice, k) => ({
      label: choice.label,
      aside: phase.choices.length === phase.intervals ? asInterval(phase, k + 1) : "",
      key: touch ? "" : choice.keys[0] ?? "", primary: true, does: "answer", choice: k + 1 })),
  };
}

/** Which answer was the right one: "It was the second turn." */
function rightAnswer(phase: Phase, given: Feedback): string {
  if (phase.choices.length !== phase.intervals) return `The answer was “${phase.choices[given.answer - 1]?.label ?? ""}”.`;
  const aside = asInterval(phase, given.answer);
  return `It was the ${turn(given.answer)}${aside ? ` (${aside})` : ""}.`;
}

function feedback(phase: Phase): View {
  const given = phase.feedback ?? { right: false, answer: 0 };
  const title = given.right ? "That was right." : "That was not right.";
  const answer = rightAnswer(phase, given);
  return { title, paragraphs: [answer], stage: false, spoken: `${title} ${answer}`, actions: [] };
}

function thanks(): View {
  return {
    title: "Thank you",
    paragraphs: ["All your answers are saved. One last thing, if you like: how did you decide?"],
    stage: false,
    spoken: "Thank you. All your answers are saved.",
    actions: [{ label: "Send and finish", key: "", primary: true, does: "strategy" }],
  };
}

function end(): View {
  return {
    title: "That was all",
    paragraphs: ["Thank you for taking part. You may close this window."],
    stage: false,
    spoken: "That was all. You may close this window.",
    actions: [],
  };
}

function fault(): View {
  return {
    title: "A short break",
    paragraphs: [
      "The simulation has stopped by itself, to be on the safe side. Please tell the person beside you.",
      "All your answers are saved; this question will start anew.",
    ],
    stage: false,
    spoken: "A short break. Please tell the person beside you.",
    actions: [nextButton("Go on")],
  };
}

export function viewOf(phase: Phase): View {
  switch (phase.phase) {
    case "welcome": return welcome(phase);
    case "gesture": return gesture();
    case "ready": return ready(phase);
    case "interval": return interval(phase);
    case "pause": return pause(phase);
    case "again": return again(phase);
    case "question": return question(phase);
    case "feedback": return feedback(phase);
    case "thanks": return thanks();
    case "end": return end();
    case "fault": return fault();
  }
}

function apart(title: string, paragraph: string): View {
  return { title, paragraphs: [paragraph], stage: false, spoken: `${title}. ${paragraph}`, actions: [] };
}

export const lostView = apart(
  "One moment, please",
  "The connection to the program was lost. Your answers are safe. This page goes on by itself when the program " +
  "is back; if it does not, please tell the person beside you.");

export const takenOverView = apart(
  "Open in another window",
  "The session goes on in the window that was opened last. You may close this one.");
