// Two runs side by side: b against a, with paired differences when they share their random numbers.

import { api } from '../api';
import { fragment, h, table } from '../dom';
import { estimateText, unitText } from '../format';
import { t } from '../i18n';
import { difference, type Difference } from '../logic/statistics';
import { section, type PageMaker } from '../page';
import type { Kpi } from '../types';

export const comparePage: PageMaker = async (context, [first = '', second = '']) => {
  const [a, b] = await Promise.all([api.run(first, true, context.signal), api.run(second, true, context.signal)]);
  const paired = a.seed === b.seed && a.replications === b.replications;
  interface Row {
    kpi: Kpi;
    a: Kpi | undefined;
    b: Kpi | undefined;
    difference: Difference | null;
  }
  const names = [...new Map([...a.kpis, ...b.kpis].map((k) => [k.name, k])).values()];
  const rows: Row[] = names
    .map((kpi) => {
      const [x, y] = [a.kpis.find((k) => k.name === kpi.name), b.kpis.find((k) => k.name === kpi.name)];
      return { kpi, a: x, b: y, difference: x && y ? difference(x.values ?? [], y.values ?? [], paired) : null };
    })
    // What is nought in both says nothing.
    .filter((r) => !(r.a?.mean === 0 && r.b?.mean === 0));
  return {
    title: t('compare.title', { a: a.id, b: b.id }),
    body: fragment(
      h('h1', {}, t('compare.title', { a: a.id, b: b.id })),
      h('p', {}, h('a', { href: `#/runs/${a.id}` }, t('compare.run', { id: a.id })), `: ${a.scenario}, ${a.label}`, h('br'), h('a', { href: `#/runs/${b.id}` }, t('compare.run', { id: b.id })), `: ${b.scenario}, ${b.label}`),
      h('p', { class: 'muted' }, paired ? t('compare.paired', { seed: a.seed }) : t('compare.unpaired')),
      a.currency !== b.currency ? h('p', { class: 'bad' }, t('compare.currency', { a: a.currency, b: b.currency })) : null,
      section(
        t('run.all'),
        '',
        table<Row>(
          t('compare.title', { a: a.id, b: b.id }),
          [
            { head: t('col.name'), rowHead: true, cell: (r) => h('code', { title: r.kpi.meaning }, r.kpi.name) },
            { head: t('compare.run', { id: a.id }), number: true, cell: (r) => estimateText(r.a?.mean, r.a?.half_width_95) },
            { head: t('compare.run', { id: b.id }), number: true, cell: (r) => estimateText(r.b?.mean, r.b?.half_width_95) },
            { head: t('col.difference'), number: true, cell: (r) => (r.difference ? estimateText(r.difference.mean, r.difference.halfWidth) : '–') },
            { head: t('col.unit'), cell: (r) => h('span', { class: 'unit' }, unitText(r.kpi.unit) || '1') },
            { head: `${t('col.verdict')} (95 %)`, cell: (r) => (r.difference ? h('span', { class: `verdict ${r.difference.verdict}` }, t(`compare.${r.difference.verdict}`)) : '–') },
          ],
          rows,
        ),
      ),
    ),
  };
};
