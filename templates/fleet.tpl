{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Fleet sheet</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#robots">Skip to the robots</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · archive</p>
<h1>Fleet sheet</h1>
<p class="subtitle">Every joint's results compared with those of the others and with its own past.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT:x-dates}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<main id="content" class="page-body">
{{>VERDICT}}
{{#CHANGES}}<section id="changes" aria-labelledby="changes-title">
<h2 id="changes-title">Joints that change</h2>
<p>By each joint's own history (<code>tribolog archive trend</code>). Of 250 joints that do not change about one is listed by chance.</p>
<ul>
{{#CHANGE}}<li><b><bdi>{{ROBOT}}</bdi>, joint <bdi>{{JOINT}}</bdi>:</b> {{TEXT}}</li>
{{/CHANGE}}</ul>
{{#MORE_IF}}<p>{{MORE}}</p>{{/MORE_IF}}
</section>
{{/CHANGES}}{{#OUTLIERS}}<section id="outliers" aria-labelledby="outliers-title">
<h2 id="outliers-title">Outliers, furthest first</h2>
<p><i>z</i> tells by how many standard deviations the latest result is away from the median of the other robots, or of the joint's own past; beyond ±{{LIMIT}} it stands out. A result may be far from those of the other robots without having changed: a robot's trends show its own past alone.</p>
<div class="cards">
{{#CARD}}<article class="outlier">
<h3>{{#LINK}}<a href="{{HREF}}"><bdi>{{TEXT}}</bdi></a>{{/LINK}}{{#NO_LINK}}<bdi>{{TEXT}}</bdi>{{/NO_LINK}} <span class="unit"><bdi>{{ROBOT}}</bdi></span></h3>
{{#QUANTITY}}<div class="outlying"><svg class="spark"><path d="{{BAND}}"/><path d="{{OTHERS}}"/><path d="{{HISTORY}}"/><path d="{{LATEST}}"/></svg>
<p><b>{{NAME}}</b> {{VALUE}}{{#VERDICT_IF}} ({{VERDICT}}){{/VERDICT_IF}}{{#OTHERS_WORDS_IF}}<small>{{OTHERS_WORDS}}</small>{{/OTHERS_WORDS_IF}}{{#HISTORY_WORDS_IF}}<small>{{HISTORY_WORDS}}</small>{{/HISTORY_WORDS_IF}}</p></div>
{{/QUANTITY}}<p class="from">{{MEASURED}} · <code>{{#LINK}}{{ID}}{{/LINK}}{{#NO_LINK}}tribolog archive report {{ID}} -o {{ID}}.html{{/NO_LINK}}</code>{{#TREND}} <a href="{{HREF}}">Trends of this robot</a>{{/TREND}}</p>
</article>
{{/CARD}}</div>
{{#MORE_IF}}<p>{{MORE}}</p>{{/MORE_IF}}
</section>
{{/OUTLIERS}}<section id="robots" aria-labelledby="robots-title">
<h2 id="robots-title">Joints, those of the robot furthest off first</h2>
<p>A joint's name leads to its report where one lies beside this page or in its folder <code>reports</code>. To write one: <code>tribolog archive report ID -o ID.html</code>, with the ID in the last column; to write all: <code>--reports reports</code>. A robot's trends, where <code>--trends trends</code> has written them, are behind its name.</p>
<p class="find" hidden><label>Robot, joint, day or ID <input type="search" id="fleet-find"></label> <output id="fleet-found" for="fleet-find"></output></p>
<div id="fleet">
{{#TABLE}}<div class="some"><table class="fleet"><caption class="spoken">Latest results of the joints</caption><thead><tr><th scope="col" class="of">Robot</th><th scope="col" class="joint">Joint</th><th scope="col" class="day">Latest</th>{{#HEAD}}<th scope="col">{{WORDS}} <span class="unit">[{{UNIT}}]</span></th>{{/HEAD}}<th scope="col" class="id">ID</th></tr></thead><tbody>
{{#JOINT}}<tr><td class="of">{{#TREND}}<a class="trend" href="{{HREF}}"><bdi>{{ROBOT}}</bdi></a>{{/TREND}}{{#NO_TREND}}<bdi>{{ROBOT}}</bdi>{{/NO_TREND}}</td><th scope="row">{{#LINK}}<a href="{{HREF}}"><bdi>{{TEXT}}</bdi></a>{{/LINK}}{{#NO_LINK}}<bdi>{{TEXT}}</bdi>{{/NO_LINK}}</th><td class="day">{{DAY}}{{#DECISION_IF}} <small>{{DECISION}}</small>{{/DECISION_IF}}</td>{{#CELL}}{{#EMPTY}}<td></td>{{/EMPTY}}{{#FULL}}<td{{#KIND_IF}} class="{{KIND}}"{{/KIND_IF}} data-name="{{NAME}}"><svg><path d="{{BAND}}"/><path d="{{OTHERS}}"/><path d="{{HISTORY}}"/><path d="{{LATEST}}"/></svg>{{VALUE}}</td>{{/FULL}}{{/CELL}}<td class="id">{{ID}}</td></tr>
{{/JOINT}}</tbody></table></div>
{{/TABLE}}</div>
</section>
<section id="how" aria-labelledby="how-title">
<h2 id="how-title">How to read it</h2>
<p class="spark-key"><svg class="spark"><path d="M0 10h184v32H0z"/><path d="M0 20h184"/><path d="M5 30 34 22 63 28 92 25 121 27 150 21 179 12M179 5V19"/><path d="M179 12h0"/></svg>
<span>Each small picture is one result of one joint over the period of all calibrations. The line is its history, the dot the latest result with its 95 % interval as a bar. Within the grey band the dot does not stand out from the joint's own past. The dashed line is the median of the same joint of the other robots; it is drawn at the edge if it is farther away. Each picture has its own scale. All values are SI, on the motor's side of the gear; the angle of the centre of gravity and the surrogate mass are of the joint. Red: stands out. Grey: the verdict on it is not usable.</span></p>
<details><summary>How outliers are found</summary>
<p>The latest result <i>x</i> with the half width <i>h</i> of its 95 % interval is compared with the median <i>m</i> of <i>n</i> others, once of the same joint on other robots (at least {{OTHERS_NEEDED}}), once of its own earlier calibrations (at least {{EARLIER_NEEDED}}): <i>t</i> = (<i>x</i> − <i>m</i>) / max(<i>s</i> √(1 + π/(2<i>n</i>)), <i>h</i>/1.96). <i>s</i> is the scatter Q<sub>n</sub> of Rousseeuw and Croux, which outliers do not affect: of the latest results of all such joints, or of all their earlier ones, each about the median of its own joint. <i>z</i> is the normal deviate as improbable as <i>t</i> is in Student's distribution with 0.82 (<i>N</i> − 1) degrees of freedom, <i>N</i> being the number of values behind <i>s</i>.</p>
<p>A joint stands out where |<i>z</i>| of one of its results is beyond {{LIMIT}}: at least 3.5, and so large that of the {{DISTANCES}} distances on this page half of one would be expected beyond it by chance. The same joint: one of the same name and gear ratio, on robots of the same name where there are six or more, otherwise on all. Temperature and payload are not taken into account: a joint that was measured cold may stand out for that reason.</p>
</details>
</section>
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made</h2>
<p>Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</main>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}}</p></footer>
<script>{{SCRIPT:x-script}}</script>
</body>
</html>
