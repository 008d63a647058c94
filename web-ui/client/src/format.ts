// How numbers, units and times are printed. Two digits of the uncertainty; the mean no finer than that: the rule of
// the command line's tables.

import { language } from './i18n';

const formats = new Map<string, Intl.NumberFormat>();

function formatter(options: Intl.NumberFormatOptions): Intl.NumberFormat {
  const locale = language() === 'uk' ? 'uk-UA' : 'en-GB';
  const key = locale + JSON.stringify(options);
  let f = formats.get(key);
  if (!f) formats.set(key, (f = new Intl.NumberFormat(locale, options)));
  return f;
}

/** With so many decimals; what rounds to nought has no sign. */
export function fixed(x: number, digits: number): string {
  return formatter({ minimumFractionDigits: digits, maximumFractionDigits: digits }).format(Number(x.toFixed(Math.min(100, digits))) === 0 ? 0 : x);
}

/** Six (or so many) significant digits; very large and very small numbers with an exponent. */
export function significant(x: number, digits = 6): string {
  if (x === 0) return '0';
  const size = Math.abs(x);
  if (size >= 1e9 || size < 1e-4) return formatter({ notation: 'scientific', maximumSignificantDigits: digits }).format(x).replace('E', '·10^');
  return formatter({ maximumSignificantDigits: digits }).format(x);
}

/** Decimals that show two digits of the uncertainty. */
export function decimalsFor(halfWidth: number): number {
  return Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(halfWidth))));
}

const roundingNoise = 1e-11;

/** Mean and half-width as texts; `scale` 100 for percent. The half-width is '' when there is none or it is zero. */
export function estimate(mean: number | null | undefined, halfWidth: number | null | undefined, scale = 1): { mean: string; half: string } {
  if (mean === null || mean === undefined) return { mean: '–', half: '' };
  // What is left of a scatter of nought after rounding is no uncertainty.
  if (halfWidth === null || halfWidth === undefined || halfWidth <= roundingNoise * Math.abs(mean)) return { mean: significant(mean * scale), half: '' };
  const digits = decimalsFor(halfWidth * scale);
  return { mean: fixed(mean * scale, digits), half: fixed(halfWidth * scale, digits) };
}

/** "149.72 ± 0.43" */
export function estimateText(mean: number | null | undefined, halfWidth: number | null | undefined, scale = 1): string {
  const e = estimate(mean, halfWidth, scale);
  return e.half ? `${e.mean} ± ${e.half}` : e.mean;
}

/** The unit as printed: nothing for plain numbers. */
export function unitText(unit: string): string {
  return unit === '1' || unit === '-' ? '' : unit.replace(/(\w)\^2\b/g, '$1²').replace(/(\w)\^3\b/g, '$1³');
}

export function whole(x: number): string {
  return formatter({ maximumFractionDigits: 0 }).format(x);
}

/** Local date and time of a UTC time stamp; the text itself when it is none. */
export function dateTime(iso: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  return new Intl.DateTimeFormat(language() === 'uk' ? 'uk-UA' : 'en-GB', { dateStyle: 'medium', timeStyle: 'short' }).format(date);
}
