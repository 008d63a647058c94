// The Gantt chart of one replication, of a run or from a trace file: from a year to a minute, drawn by pixels.

import { api, ApiError } from '../api';
import { colourOf, currentTheme } from '../charts/theme';
import { fragment, h, table } from '../dom';
import { fixed, significant, whole } from '../format';
import { named, t } from '../i18n';
import { toCsv } from '../logic/csv';
import { parseNumber } from '../logic/fields';
import { bars, compactTrace, edgeTable, firstAfter, intervalTable, mostTableRows, nothing, readTrace, startOf, stateShares, type RowKind, type Trace, type TraceRow } from '../logic/gantt';
import { section, type PageContext, type PageMaker } from '../page';
import { jobPanel } from '../ui/job';
import { saveMenu, type SaveItem } from '../ui/save';
import { hourSection, queueSection, shiftSection, wipSection } from './traceParts';

const rowHeight = 22;
const axisHeight = 26;
const labelWidth = 150;
const shortest = 1; // minutes across the picture
/** A canvas of more rows is too high for browsers, and for people. */
const mostRows = 250;
const kinds: readonly RowKind[] = ['machine', 'crew', 'tool'];

export const tracePage: PageMaker = async (context, [run = '']) => {
  const version = await api.version(context.signal);
  const place = h('div');
  const note = h('p', { class: 'bad', role: 'alert' });
  const file = h('input', { id: 'trace-file', type: 'file', accept: '.json,application/json', onchange: () => {
    const chosen = file.files?.[0];
    if (!chosen) return;
    note.textContent = '';
    void chosen.text().then((text) => {
      file.value = ''; // the same file may be chosen again when it has changed
      try {
        place.replaceChildren(gantt(context, readTrace(JSON.parse(text)), chosen.name));
      } catch (e) {
        note.textContent = `${chosen.name}: ${e instanceof Error ? e.message : String(e)}`;
      }
    });
  } });
  const replication = h('input', { id: 'trace-replication', type: 'text', inputmode: 'numeric', value: '1', size: 4 });
  const jobs = h('div');
  const record = () => {
    note.textContent = '';
    const which = parseNumber(replication.value);
    if (which === null || !Number.isInteger(which) || which < 1) return void (note.textContent = t('models.bad.integer'));
    api.startJob({ kind: 'trace', run: Number(run), replication: which - 1 }).then(
      (job) => jobs.replaceChildren(jobPanel(context, job, (end) => {
        if (end.state !== 'finished') return;
        api.jobOutput(end.id, context.signal).then(
          (json) => place.replaceChildren(gantt(context, readTrace(json), `${end.title}, ${t('trace.replication')} ${Number(end.result?.replication ?? 0) + 1}`)),
        ).catch((e: unknown) => (note.textContent = e instanceof Error ? e.message : String(e)));
      })),
      (e: unknown) => (note.textContent = e instanceof ApiError && e.message ? e.message : t('state.offline')),
    );
  };
  const ofRun = run === '' ? null : section(t('run.title', { id: run }), '', h('p', { class: 'row no-print' }, h('label', { for: 'trace-replication' }, t('trace.replication')), replication, h('button', { type: 'button', id: 'record', disabled: version.read_only, onclick: record }, t('trace.record')), h('a', { href: `#/runs/${run}` }, t('run.title', { id: run }))), jobs);
  return {
    title: t('nav.trace'),
    body: fragment(h('h1', {}, t('nav.trace')), ofRun, section(t('trace.open'), '', h('p', { class: 'row no-print' }, h('label', { for: 'trace-file' }, t('trace.file')), file), h('p', { class: 'muted' }, t('trace.hint')), note), place),
  };
};

function gantt(context: PageContext, trace: Trace, name: string): DocumentFragment {
  let [from, to] = [0, trace.end];
  const count = trace.states.length;
  const present = kinds.filter((k) => trace.rows.some((r) => r.kind === k));
  // Tools by the hundred would bury the machines: they are shown when asked for.
  const shownKinds = new Set(present.filter((k) => k !== 'tool' || trace.rows.length <= mostRows / 2));
  let words: string[] = [];
  let rows: TraceRow[] = [];
  let height = 0;
  const canvas = h('canvas', { class: 'gantt', tabindex: 0, role: 'img' });
  const window_ = h('p', { class: 'muted', role: 'status', id: 'trace-window' });
  const left = h('p', { class: 'muted', id: 'trace-left' });
  const under = h('p', { class: 'muted', id: 'trace-under' }, '\u00a0');
  const shares = h('div');
  const note = h('p', { class: 'bad', role: 'alert' });
  const colours = trace.states.map((s, k) => colourOf(s, k));

  const choose = () => {
    const all = trace.rows.filter((r) => shownKinds.has(r.kind) && words.every((w) => r.name.toLowerCase().includes(w)));
    rows = all.slice(0, mostRows);
    left.textContent = all.length > rows.length ? t('trace.tooMany', { shown: rows.length, total: whole(all.length) }) : all.length === 0 ? t('trace.noRow') : '';
    height = rows.length * rowHeight + axisHeight;
    canvas.style.height = `${height}px`;
    canvas.setAttribute('aria-label', t('trace.label', { rows: rows.length }));
  };
  const paint = () => {
    const begun = performance.now();
    const theme = currentTheme();
    const ratio = Math.min(devicePixelRatio || 1, 16_000 / height);
    const width = canvas.clientWidth || 800;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const g = canvas.getContext('2d');
    if (!g) return;
    g.scale(ratio, ratio);
    g.clearRect(0, 0, width, height);
    g.font = `12px ${theme.font}`;
    g.textBaseline = 'middle';
    const pixels = width - labelWidth;
    let drawn = 0;
    rows.forEach((row, r) => {
      const y = r * rowHeight;
      g.fillStyle = theme.text;
      g.fillText(row.name, 0, y + rowHeight / 2, labelWidth - 8);
      let last = -1;
      const least = 0.3 / (ratio * (rowHeight - 4)); // thinner than a third of a pixel is not seen
      for (const bar of bars(row, from, to, pixels, count)) {
        if (bar.height < least) continue;
        if (bar.state !== last) g.fillStyle = colours[(last = bar.state)] ?? theme.muted;
        g.fillRect(labelWidth + bar.x, y + 2 + bar.top * (rowHeight - 4), Math.max(1, bar.width), bar.height * (rowHeight - 4));
        ++drawn;
      }
    });
    g.fillStyle = theme.muted;
    g.strokeStyle = theme.line;
    const step = niceStep((to - from) / Math.max(2, pixels / 110));
    for (let time = Math.ceil(from / step) * step; time <= to; time += step) {
      const x = labelWidth + ((time - from) / (to - from)) * pixels;
      g.beginPath();
      g.moveTo(x, 0);
      g.lineTo(x, height - axisHeight);
      g.stroke();
      g.fillText(clock(time), Math.min(x, width - 60), height - axisHeight / 2);
    }
    canvas.dataset['bars'] = String(drawn);
    canvas.dataset['ms'] = (performance.now() - begun).toFixed(1);
    canvas.dataset['from'] = String(from);
    canvas.dataset['to'] = String(to);
    window_.textContent = t('trace.window', { from: clock(from), to: clock(to), length: clock(to - from) });
  };
  const fillShares = () => {
    const own = rows.filter((r) => r.kind !== 'tool').map((r) => ({ r, share: stateShares(r, from, to, count) }));
    type Row = (typeof own)[number];
    const used = trace.states.flatMap((_, s) => (own.some((x) => (x.share[s] ?? 0) > 0) ? [s] : []));
    shares.replaceChildren(
      table<Row>(t('trace.shares'), [
        { head: t('col.name'), rowHead: true, cell: (x) => x.r.name },
        ...used.map((s) => ({ head: fragment(swatch(colours[s] ?? ''), named('state', trace.states[s] ?? '')), unit: '%', number: true, cell: (x: Row) => fixed(100 * (x.share[s] ?? 0), 1), raw: (x: Row) => 100 * (x.share[s] ?? 0) })),
      ], own),
    );
  };
  // A wheel turns faster than screens draw: one picture a frame; the table when it has come to rest.
  let frame = 0;
  let rest = 0;
  const draw = () => {
    frame ||= requestAnimationFrame(() => {
      frame = 0;
      paint();
    });
    clearTimeout(rest);
    rest = window.setTimeout(fillShares, 150);
  };
  const show = (a: number, b: number) => {
    const length = Math.min(trace.end, Math.max(shortest, b - a));
    from = Math.max(0, Math.min(trace.end - length, a));
    to = from + length;
    draw();
  };
  const zoom = (factor: number, centre = 0.5) => {
    const middle = from + centre * (to - from);
    show(middle - centre * (to - from) * factor, middle + (1 - centre) * (to - from) * factor);
  };
  const timeAt = (event: MouseEvent) => (event.offsetX - labelWidth) / Math.max(1, canvas.clientWidth - labelWidth);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(event.deltaY > 0 ? 1.4 : 1 / 1.4, Math.min(1, Math.max(0, timeAt(event))));
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const quarter = (to - from) / 4;
    const action: Record<string, () => void> = { '+': () => zoom(0.5), '=': () => zoom(0.5), '-': () => zoom(2), ArrowLeft: () => show(from - quarter, to - quarter), ArrowRight: () => show(from + quarter, to + quarter), Home: () => show(0, trace.end) };
    const act = action[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  canvas.addEventListener('mousemove', (event) => {
    const row = rows[Math.floor(event.offsetY / rowHeight)];
    const time = from + timeAt(event) * (to - from);
    const k = row && time >= row.start ? firstAfter(row.until, time) : -1;
    const state = row?.state[k];
    if (!row || state === undefined || state === nothing) return void (under.textContent = '\u00a0');
    const [begin, end] = [startOf(row, k), row.until[k] ?? 0];
    const machine = trace.machines[row.at?.[k] ?? -1];
    under.textContent = `${row.name}, ${clock(time)}: ${named('state', trace.states[state] ?? '')}${machine ? ` (${machine})` : ''}, ${clock(begin)} … ${clock(end)} (${significant(end - begin, 4)} min)`;
  });
  context.whenLeft(() => {
    observer.disconnect();
    cancelAnimationFrame(frame);
    clearTimeout(rest);
  });
  const observer = new ResizeObserver(() => draw());
  choose();
  fillShares();
  requestAnimationFrame(() => observer.observe(canvas));
  const button = (text: string, act: () => void) => h('button', { type: 'button', class: 'quiet', onclick: act }, text);
  const again = () => {
    choose();
    draw();
  };
  const filter = h('input', { id: 'trace-filter', type: 'search', oninput: () => { words = filter.value.toLowerCase().split(/\s+/).filter(Boolean); again(); } });
  const boxes = present.map((kind) => {
    const box = h('input', { type: 'checkbox', id: `trace-${kind}`, checked: shownKinds.has(kind), onchange: () => { if (box.checked) shownKinds.add(kind); else shownKinds.delete(kind); again(); } });
    return h('label', { for: box.id }, box, ` ${t(`trace.kind.${kind}`)}`);
  });
  const csv = (label: string, file: string, rowsOf: () => (string | number)[][] | null, excel: boolean): SaveItem => ({
    label, file,
    content: () => {
      note.textContent = '';
      const list = rowsOf();
      if (list) return new Blob([toCsv(list, excel ? { separator: ';', decimal: ',' } : { separator: ',', decimal: '.' })], { type: 'text/csv;charset=utf-8' });
      note.textContent = t('trace.tooLarge', { most: whole(mostTableRows) });
      return null;
    },
  });
  const shown = () => intervalTable({ ...trace, rows }, from, to);
  const edges = () => edgeTable(trace);
  return fragment(
    section(
      name,
      '',
      h('p', { class: 'row no-print' }, button(t('trace.in'), () => zoom(0.5)), button(t('trace.out'), () => zoom(2)), button('◀', () => show(from - (to - from) / 4, to - (to - from) / 4)), button('▶', () => show(from + (to - from) / 4, to + (to - from) / 4)), button(t('trace.all'), () => show(0, trace.end)), button(t('trace.minute'), () => show((from + to) / 2 - 0.5, (from + to) / 2 + 0.5))),
      h('p', { class: 'row no-print' }, boxes, h('label', { for: 'trace-filter' }, t('run.filter')), filter),
      window_,
      h('p', { class: 'legend' }, trace.states.map((s, k) => h('span', {}, swatch(colours[k] ?? ''), named('state', s), ' '))),
      canvas,
      left,
      under,
      saveMenu(name, [
        { label: 'PNG', file: 'gantt.png', content: () => new Promise<Blob>((resolve) => canvas.toBlob((b) => resolve(b ?? new Blob()))) },
        csv(t('trace.saveShown'), 'gantt.csv', shown, false),
        csv(t('trace.saveShownExcel'), 'gantt.csv', shown, true),
        ...(trace.edges.length > 0 ? [csv(t('trace.saveEdges'), 'edges.csv', edges, false), csv(t('trace.saveEdgesExcel'), 'edges.csv', edges, true)] : []),
        { label: t('trace.saveTrace'), file: 'trace.json', content: () => new Blob([JSON.stringify(compactTrace(trace))], { type: 'application/json' }) },
      ]),
      note,
    ),
    section(t('trace.shares'), '%', shares),
    shiftSection(context, trace),
    hourSection(context, trace),
    queueSection(context, trace),
    wipSection(context, trace),
  );
}

function swatch(colour: string): HTMLElement {
  const box = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  box.style.background = colour;
  return box;
}

/** Minutes as days, hours and minutes. */
export function clock(minutes: number): string {
  const sign = minutes < 0 ? '-' : '';
  const m = Math.abs(minutes);
  const days = Math.floor(m / 1440);
  const hours = Math.floor((m % 1440) / 60);
  const rest = m % 60;
  const two = (x: number) => String(x).padStart(2, '0');
  const seconds = Math.round((rest % 1) * 60);
  return `${sign}${days > 0 ? `${days} ${t('trace.day')} ` : ''}${two(hours)}:${two(Math.floor(rest))}${seconds > 0 && seconds < 60 ? `:${two(seconds)}` : ''}`;
}

function niceStep(least: number): number {
  for (const step of [1 / 60, 1 / 12, 0.25, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 240, 480, 720, 1440, 2880, 7200, 14400, 43200, 86400]) if (step >= least) return step;
  return Math.ceil(least / 86400) * 86400;
}
