// The Gantt chart of one replication, of a run or from a trace file: from a year to a minute, drawn by pixels.

import { api, ApiError } from '../api';
import { chart } from '../charts/chart';
import { queueOption } from '../charts/queues';
import { timeBars } from '../charts/timeBars';
import { colourOf, currentTheme } from '../charts/theme';
import { fragment, h, table } from '../dom';
import { fixed, significant } from '../format';
import { named, t } from '../i18n';
import { roundKeepingSum } from '../logic/shares';
import { bars, hourShares, readTrace, stateShares, type Trace, type TraceRow } from '../logic/gantt';
import { section, type PageContext, type PageMaker } from '../page';
import { jobPanel } from '../ui/job';
import { saveMenu } from '../ui/save';

const rowHeight = 22;
const axisHeight = 26;
const labelWidth = 130;
const shortest = 1; // minutes across the picture

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
    api.startJob({ kind: 'trace', run: Number(run), replication: Math.max(0, Math.round(Number(replication.value)) - 1) }).then(
      (job) => jobs.replaceChildren(jobPanel(context, job, (end) => {
        if (end.state !== 'finished') return;
        api.jobOutput(end.id, context.signal).then(
          (json) => place.replaceChildren(gantt(context, readTrace(json), `${end.title}, ${t('trace.replication')} ${Number(end.result?.replication ?? 0) + 1}`)),
          (e: unknown) => (note.textContent = e instanceof Error ? e.message : String(e)),
        );
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
  const canvas = h('canvas', { class: 'gantt', tabindex: 0, role: 'img', 'aria-label': t('trace.label', { rows: trace.rows.length }) });
  const window_ = h('p', { class: 'muted', role: 'status', id: 'trace-window' });
  const under = h('p', { class: 'muted', id: 'trace-under' }, '\u00a0');
  const shares = h('div');
  const colour = (state: string) => colourOf(state, trace.states.indexOf(state));
  const height = trace.rows.length * rowHeight + axisHeight;
  canvas.style.height = `${height}px`;

  const draw = () => {
    const theme = currentTheme();
    const ratio = devicePixelRatio || 1;
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
    trace.rows.forEach((row, r) => {
      const y = r * rowHeight;
      g.fillStyle = theme.text;
      g.fillText(row.name, 0, y + rowHeight / 2, labelWidth - 8);
      for (const bar of bars(row, from, to, pixels)) {
        g.fillStyle = colour(bar.state);
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
    window_.textContent = t('trace.window', { from: clock(from), to: clock(to), length: clock(to - from) });
    shares.replaceChildren(
      table<TraceRow>(t('trace.shares'), [
        { head: t('col.name'), rowHead: true, cell: (r) => r.name },
        ...trace.states.filter((state) => !state.startsWith('edge_')).map((state) => ({ head: fragment(swatch(colour(state)), named('state', state)), unit: '%', number: true, cell: (r: TraceRow) => fixed(100 * (stateShares(r, from, to).get(state) ?? 0), 1), raw: (r: TraceRow) => 100 * (stateShares(r, from, to).get(state) ?? 0) })),
      ], trace.rows.filter((r) => !r.tool)),
    );
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
    const row = trace.rows[Math.floor(event.offsetY / rowHeight)];
    const time = from + timeAt(event) * (to - from);
    const hit = row?.intervals.find(([a, b]) => a <= time && time < b);
    under.textContent = row && hit ? `${row.name}, ${clock(time)}: ${named('state', hit[2])}, ${clock(hit[0])} … ${clock(hit[1])} (${significant(hit[1] - hit[0], 4)} min)` : '\u00a0';
  });
  context.whenLeft(() => observer.disconnect());
  const observer = new ResizeObserver(() => draw());
  requestAnimationFrame(() => observer.observe(canvas));
  const button = (text: string, act: () => void) => h('button', { type: 'button', class: 'quiet', onclick: act }, text);
  return fragment(
    section(
      name,
      '',
      h('p', { class: 'row no-print' }, button(t('trace.in'), () => zoom(0.5)), button(t('trace.out'), () => zoom(2)), button('◀', () => show(from - (to - from) / 4, to - (to - from) / 4)), button('▶', () => show(from + (to - from) / 4, to + (to - from) / 4)), button(t('trace.all'), () => show(0, trace.end)), button(t('trace.minute'), () => show((from + to) / 2 - 0.5, (from + to) / 2 + 0.5))),
      window_,
      h('p', { class: 'legend' }, trace.states.map((s) => h('span', {}, swatch(colour(s)), named('state', s), ' '))),
      canvas,
      under,
      saveMenu(name, [{ label: 'PNG', file: 'gantt.png', content: () => new Promise<Blob>((resolve) => canvas.toBlob((b) => resolve(b ?? new Blob()))) }, { label: 'JSON', file: 'trace.json', content: () => new Blob([JSON.stringify({ machines: trace.rows })], { type: 'application/json' }) }]),
    ),
    section(t('trace.shares'), '%', shares),
    hourSection(context, trace),
    queueSection(context, trace),
    wipSection(context, trace),
  );
}

/** How many batches wait before each machine group. */
function queueSection(context: PageContext, trace: Trace): HTMLElement | null {
  if (trace.queues.length === 0) return null;
  const drawers: (() => void)[] = [];
  const picture = chart({ ...context, whenShown: (d) => drawers.push(d) }, t('trace.queues'), 'large', (theme) => queueOption(trace.queues, trace.end, theme), { name: t('trace.queues'), data: () => [['machine', 'min', 'waiting'], ...trace.queues.flatMap((q) => q.points.map(([time, n]) => [q.name, time, n]))] });
  requestAnimationFrame(() => drawers.forEach((d) => d()));
  return section(t('trace.queues'), '', picture.element);
}

/** What a machine does at each hour of the day, over the whole trace. */
function hourSection(context: PageContext, trace: Trace): HTMLElement | null {
  const rows = trace.rows.filter((r) => !r.tool);
  if (rows.length === 0 || trace.end < 1440) return null;
  const drawers: (() => void)[] = [];
  let row = rows[0] as TraceRow;
  const states = () => [...new Set(row.intervals.map((i) => i[2]))];
  const hours = () => {
    const shares = hourShares(row);
    return shares.map((s, hour) => ({ machine: `${String(hour).padStart(2, '0')}:00`, percent: roundKeepingSum(states().map((state) => 100 * (s.get(state) ?? 0)), 1) }));
  };
  const shown = h('div');
  const picture = chart({ ...context, whenShown: (d) => drawers.push(d) }, t('trace.hours'), 'hours', (theme) => timeBars(states().map((s) => named('state', s)), hours(), theme, states()), { name: t('trace.hours'), data: () => [['hour', ...states()], ...hours().map((x) => [x.machine, ...x.percent])] });
  const fill = () => {
    const keys = states();
    const list = hours();
    shown.replaceChildren(table<(typeof list)[number]>(t('trace.hours'), [
      { head: t('trace.hour'), rowHead: true, cell: (x) => x.machine },
      ...keys.map((state, k) => ({ head: named('state', state), unit: '%', number: true, cell: (x: (typeof list)[number]) => fixed(x.percent[k] ?? 0, 1), raw: (x: (typeof list)[number]) => x.percent[k] })),
    ], list));
  };
  const pick = h('select', { id: 'hours-machine', onchange: () => { row = rows[Number(pick.value)] ?? row; picture.redraw(); fill(); } }, rows.map((r, k) => h('option', { value: k }, r.name)));
  fill();
  requestAnimationFrame(() => drawers.forEach((d) => d()));
  return section(t('trace.hours'), '%', h('p', { class: 'row no-print' }, h('label', { for: 'hours-machine' }, t('col.machine')), pick), picture.element, h('details', { id: 'hours-table' }, h('summary', {}, t('trace.asTable')), shown));
}

/** How many parts are in the shop. */
function wipSection(context: PageContext, trace: Trace): HTMLElement | null {
  if (trace.wip.length === 0) return null;
  const drawers: (() => void)[] = [];
  const end = trace.wip.at(-1)?.[0] ?? trace.end;
  const picture = chart({ ...context, whenShown: (d) => drawers.push(d) }, t('trace.wip'), 'large', (theme) => queueOption([{ name: t('trace.wip'), points: trace.wip }], end, theme, t('trace.parts')), { name: t('trace.wip'), data: () => [['min', 'parts'], ...trace.wip] });
  requestAnimationFrame(() => drawers.forEach((d) => d()));
  return section(t('trace.wip'), '', picture.element, h('p', { class: 'muted' }, t('trace.wipHint')));
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
