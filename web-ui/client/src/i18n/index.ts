// The language of the pages: the user's choice, else the browser's, else English.

import { en, type Key } from './en';
import { uk } from './uk';

export type Language = 'en' | 'uk';
export const dictionaries: Record<Language, Record<Key, string>> = { en, uk };
export type { Key };

const storageKey = 'verstat.language';

function initial(): Language {
  try {
    const stored = localStorage.getItem(storageKey);
    if (stored === 'en' || stored === 'uk') return stored;
  } catch {
    // Storage may be switched off; the browser's language will do.
  }
  return typeof navigator !== 'undefined' && navigator.language.toLowerCase().startsWith('uk') ? 'uk' : 'en';
}

let current: Language = initial();

export const language = (): Language => current;

export function setLanguage(next: Language): void {
  current = next;
  try {
    localStorage.setItem(storageKey, next);
  } catch {
    // Not remembered, then.
  }
}

/** The text of a key with its placeholders filled in. */
export function t(key: Key, values: Record<string, string | number> = {}): string {
  return dictionaries[current][key].replace(/\{(\w+)\}/g, (whole, name: string) => (name in values ? String(values[name]) : whole));
}

/** Words for a name that comes from the data: translated when known, else the name with spaces. */
export function named(group: 'kpi' | 'state' | 'cost' | 'bridge' | 'entity' | 'phase', name: string): string {
  const key = `${group}.${name}`;
  return key in en ? t(key as Key) : name.replace(/_/g, ' ');
}
