// Where parts come from and end: widths are parts.

import { significant } from '../format';
import type { Flow } from '../logic/shop';
import { tooltip } from './chart';
import type { AnyOption } from './echarts';
import type { Theme } from './theme';

/** @param colours of the nodes that have one of their own */
export function sankeyOption(flows: readonly Flow[], colours: Record<string, string>, theme: Theme): AnyOption {
  const names = [...new Set(flows.flatMap((f) => [f.from, f.to]))];
  return {
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const { name, value, data } = p as { name: string; value: number; data: { source?: string; target?: string } };
      return `${data.source === undefined ? name : `${data.source} → ${data.target ?? ''}`}: ${significant(value, 5)}`;
    } },
    series: [{
      type: 'sankey', left: 8, right: 170, top: 8, bottom: 8, nodeGap: 14, draggable: false,
      emphasis: { focus: 'adjacency' },
      label: { color: theme.text, fontSize: 12, formatter: (p: { name: string; value?: number }) => `${p.name}: ${significant(p.value ?? 0, 4)}` },
      lineStyle: { color: 'source', opacity: 0.35 },
      data: names.map((name) => ({ name, itemStyle: { color: colours[name] ?? theme.accent, borderWidth: 0 } })),
      links: flows.map((f) => ({ source: f.from, target: f.to, value: f.value })),
    }],
  };
}
