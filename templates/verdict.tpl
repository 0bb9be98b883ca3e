{{%AUTOESCAPE context="HTML"}}
<section id="verdict" class="verdict {{OUTCOME}}" aria-labelledby="verdict-title">
<h2 id="verdict-title"><span class="icon">{{#ICON_GOOD}}<svg viewBox="0 0 24 24" width="28" height="28" aria-hidden="true"><circle cx="12" cy="12" r="11" fill="currentColor"/><path d="M6.5 12.5l3.7 3.7 7.3-8" fill="none" stroke="#fff" stroke-width="2.6"/></svg>{{/ICON_GOOD}}{{#ICON_PARTIAL}}<svg viewBox="0 0 24 24" width="28" height="28" aria-hidden="true"><path d="M12 1l11.5 21H.5z" fill="currentColor"/><path d="M12 8v7M12 17.2v2.4" fill="none" stroke="#fff" stroke-width="2.6"/></svg>{{/ICON_PARTIAL}}{{#ICON_BAD}}<svg viewBox="0 0 24 24" width="28" height="28" aria-hidden="true"><path d="M7.5 1h9L23 7.5v9L16.5 23h-9L1 16.500v-9z" fill="currentColor"/><path d="M7.500 7.500l9 9M16.500 7.500l-9 9" fill="none" stroke="#fff" stroke-width="2.6"/></svg>{{/ICON_BAD}}{{#ICON_ABSENT}}<svg viewBox="0 0 24 24" width="28" height="28" aria-hidden="true"><circle cx="12" cy="12" r="10" fill="none" stroke="currentColor" stroke-width="2"/></svg>{{/ICON_ABSENT}}</span><span class="word">{{WORD}}</span></h2>
<p class="sentence"><bdi>{{SENTENCE:x-dates}}</bdi></p>
{{#ROWS_IF}}<p class="rows">{{ROWS}}</p>
{{/ROWS_IF}}{{#FIGURES_MISSING_IF}}<p class="figures-missing"><strong>{{FIGURES_MISSING}}</strong>: all numbers are here, but not every picture; the placeholders say why.</p>{{/FIGURES_MISSING_IF}}
{{#FINDINGS}}<ul class="findings">
{{#FINDING}}<li><bdi>{{TEXT:x-dates}}</bdi></li>
{{/FINDING}}</ul>{{/FINDINGS}}
{{#NUMBERED}}<ol class="findings numbered">
{{#FINDING}}<li id="finding-{{NUMBER}}"><span class="ref">{{NUMBER}}</span> <bdi>{{TEXT:x-dates}}</bdi>{{#QUANTITIES_IF}} <small>{{QUANTITIES}}</small>{{/QUANTITIES_IF}}</li>
{{/FINDING}}</ol>{{/NUMBERED}}
{{#FURTHER_LINK}}<p class="further"><a href="#findings">{{COUNT}}</a></p>{{/FURTHER_LINK}}
{{#FURTHER}}<details><summary>{{COUNT}}</summary>
<ul class="findings">
{{#FINDING}}<li><bdi>{{TEXT:x-dates}}</bdi></li>
{{/FINDING}}</ul>
</details>{{/FURTHER}}
</section>
