// Colours of the charts. States and cost components keep theirs on every page; the palette (Okabe, Ito) can be told
// apart with any colour vision.

export interface Theme {
  font: string;
  text: string;
  muted: string;
  line: string;
  panel: string;
  accent: string;
  good: string;
  bad: string;
  cheap: string;
  middle: string;
  dear: string;
}

export function currentTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    // A canvas knows no 'inherit'.
    font: getComputedStyle(document.body).fontFamily,
    text: colour('text'),
    muted: colour('muted'),
    line: colour('line'),
    panel: colour('panel'),
    accent: colour('accent'),
    good: colour('good'),
    bad: colour('bad'),
    cheap: colour('cheap'),
    middle: colour('middle'),
    dear: colour('dear'),
  };
}

const palette = ['#0072B2', '#56B4E9', '#E69F00', '#D55E00', '#CC79A7', '#999999', '#009E73', '#8C6BB1', '#B8A000', '#5D4037'];
const known: Record<string, string> = {
  cutting: '#0072B2',
  machining: '#0072B2',
  working: '#56B4E9',
  other_operations: '#56B4E9',
  planned_change: '#E69F00',
  failure_change: '#D55E00',
  waiting_crew: '#CC79A7',
  idle: '#999999',
  inserts: '#009E73',
  regrinding: '#8C6BB1',
  damage: '#A8400B',
  scrap: '#5D4037',
  labour: '#B8A000',
  loading: '#7FB3D5',
  setup: '#F4D03F',
  waiting_tool: '#F1A7C9',
  repair: '#8E1B1B',
  waiting_repair: '#C98B8B',
  maintenance: '#6C8EBF',
  overload_reset: '#A8400B',
  warm_up: '#F5B97F',
  blocked: '#8C6BB1',
  off: '#C8CDD2',
  off_shift: '#E3E6E9',
  tool_swap: '#4DB6AC',
  free: '#B5DCC3',
  tending: '#B8A000',
  transport: '#009E73',
  tool_room: '#8C6BB1',
  edge_planned: '#56B4E9',
  edge_failed: '#D55E00',
};

/** Black or white, whichever is read better on `colour` (#rrggbb; relative luminance of WCAG 2). */
export function textOn(colour: string): string {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((k) => {
    const c = parseInt(colour.slice(k, k + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.179 ? '#000000' : '#ffffff';
}

/** Fixed colour of a known state or component, else one by its place. */
export function colourOf(name: string, place: number): string {
  return known[name] ?? palette[place % palette.length] ?? '#999999';
}
