// A quantity of a plan along one number, with the stretches where a limit is broken or the models refuse shaded.

import { significant } from '../format';
import { t } from '../i18n';
import { title } from '../logic/schema';
import type { SweepPoint } from '../types';
import { tooltip } from './chart';
import type { Option } from './echarts';
import type { Theme } from './theme';

/** Stretches [from, to] of values at which `bad` holds, reaching half-way to the neighbours. */
export function stretches(points: readonly { value: number; bad: boolean }[]): [number, number][] {
  const all: [number, number][] = [];
  points.forEach((p, k) => {
    if (!p.bad) return;
    const before = points[k - 1];
    const after = points[k + 1];
    const from = before ? (before.value + p.value) / 2 : p.value;
    const to = after ? (after.value + p.value) / 2 : p.value;
    const last = all.at(-1);
    if (last && before?.bad) last[1] = to;
    else all.push([from, to]);
  });
  return all;
}

export function sweepOption(points: readonly SweepPoint[], quantity: string, name: string, unit: string, now: number, theme: Theme): Option {
  const area = (list: [number, number][], colour: string, label: string) =>
    list.map(([from, to]) => [{ xAxis: from, name: label, itemStyle: { color: colour, opacity: 0.13 }, label: { show: false } }, { xAxis: to }] as unknown as [{ xAxis: number }, { xAxis: number }]);
  return {
    grid: { left: 66, right: 18, top: 16, bottom: 44 },
    tooltip: { ...tooltip(theme), trigger: 'axis', formatter: (p: unknown) => {
      const [first] = p as { dataIndex: number }[];
      const point = points[first?.dataIndex ?? 0];
      if (!point) return '';
      if (point.error) return `${name} ${significant(point.value)} ${unit}\n${point.error}`;
      const broken = Object.entries(point.margins ?? {}).filter(([, m]) => m < 0).map(([n]) => title(n));
      return [`${name} ${significant(point.value)} ${unit}`, `${title(quantity)} ${significant(point.quantities?.[quantity] ?? NaN)}`, ...(broken.length > 0 ? [`${t('plan.over')}: ${broken.join(', ')}`] : [])].join('\n');
    } },
    xAxis: { type: 'value', scale: true, name: unit ? `${name}, ${unit}` : name, nameLocation: 'middle', nameGap: 26, nameTextStyle: { color: theme.text }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) }, splitLine: { show: false } },
    yAxis: { type: 'value', scale: true, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 4) }, splitLine: { lineStyle: { color: theme.line } } },
    series: [
      {
        type: 'line', symbol: 'none', lineStyle: { color: theme.accent, width: 2 }, itemStyle: { color: theme.accent }, connectNulls: false,
        data: points.map((p) => [p.value, p.quantities?.[quantity] ?? null]),
        markLine: { symbol: 'none', silent: true, label: { formatter: t('plan.now'), color: theme.text }, lineStyle: { color: theme.muted, type: 'dashed' }, data: [{ xAxis: now }] },
        markArea: {
          silent: true,
          data: [
            ...area(stretches(points.map((p) => ({ value: p.value, bad: p.feasible === false }))), theme.bad, t('plan.over')),
            ...area(stretches(points.map((p) => ({ value: p.value, bad: p.error !== undefined }))), theme.muted, t('plan.refused')),
          ],
        },
      },
    ],
  };
}
