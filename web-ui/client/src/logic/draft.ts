// The scenario being worked on: where it began, as it stands, what was changed on the way, and the runs made of it.

import type { Change } from '../types';
import { changesBetween, type Json } from './pointer';

export interface Step {
  /** Pointer that was changed, or a word for a change of the whole. */
  what: string;
  json: Json;
}

export interface Draft {
  /** "heavy-lathe", "run 3" */
  origin: string;
  /** Text that the changes refer to. */
  baseText: string;
  /** The same, parsed, without changes. */
  base: Json;
  /** Everything it has been, the first entry as opened; `position` is where one stands. */
  history: Step[];
  position: number;
  /** Runs made of it here, oldest first. */
  runs: number[];
}

export const mostSteps = 200;

export function begin(origin: string, baseText: string, base: Json, now: Json): Draft {
  return { origin, baseText, base, history: [{ what: origin, json: now }], position: 0, runs: [] };
}

export function current(draft: Draft): Json {
  return draft.history[draft.position]?.json ?? null;
}

/** The draft after one more change; what had been undone before is forgotten. */
export function changed(draft: Draft, what: string, json: Json): Draft {
  const history = [...draft.history.slice(0, draft.position + 1), { what, json }];
  // The beginning stays; in a long history the oldest steps after it go.
  const kept = history.length > mostSteps ? [history[0] as Step, ...history.slice(history.length - mostSteps + 1)] : history;
  return { ...draft, history: kept, position: kept.length - 1 };
}

export function moved(draft: Draft, position: number): Draft {
  return { ...draft, position: Math.max(0, Math.min(draft.history.length - 1, position)) };
}

/**
 * What the server is sent: the text as opened and the changes against it, so that the run remembers both; or, when changes
 * cannot say it, the whole as a new text.
 */
export function request(draft: Draft): { scenario: string; changes: Change[] } {
  const now = current(draft);
  const changes = changesBetween(draft.base, now);
  const sayable = changes.length <= 500 && changes.every((c) => c.pointer !== '' && !c.pointer.includes('='));
  return sayable ? { scenario: draft.baseText, changes } : { scenario: `${JSON.stringify(now, null, 2)}\n`, changes: [] };
}

const key = 'verstat.draft';

/** What was remembered last: a draft too large for the browser's storage lasts as long as the page. */
let last: Draft | undefined;

export function remember(draft: Draft | undefined): void {
  last = draft;
  try {
    if (!draft) sessionStorage.removeItem(key);
    else sessionStorage.setItem(key, JSON.stringify({ ...draft, history: draft.history.slice(-30), position: Math.max(0, draft.position - Math.max(0, draft.history.length - 30)) }));
  } catch {
    // Too large or switched off. An older draft must not come back in its place.
    try {
      sessionStorage.removeItem(key);
    } catch {
      // Switched off.
    }
  }
}

export function recall(): Draft | undefined {
  if (last) return last;
  try {
    const text = sessionStorage.getItem(key);
    return text ? (JSON.parse(text) as Draft) : undefined;
  } catch {
    return undefined;
  }
}
