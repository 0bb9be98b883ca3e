{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>The paper's argument on {{JOINT}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the results</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · the paper's claims, put to another joint</p>
<h1>The paper's argument on “<bdi>{{JOINT}}</bdi>”</h1>
<p class="subtitle">What “Viscous friction measurement technique in robot joint with the use of surrogate mass” claims, as hypotheses, tested on a simulated joint whose truth is known.</p>
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
<li><a href="#claims">Claims</a></li>
<li><a href="#figures">Figures</a></li>
<li><a href="#selection">Masses, curves, choice</a></li>
<li><a href="#scenario">The joint that is simulated</a></li>
<li><a href="#provenance">Provenance</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
<section id="claims" class="stage" aria-labelledby="claims-title">
<h2 id="claims-title">Claims <a class="self" href="#claims" aria-label="Link to this section">#</a></h2>
<div class="table-box" id="table-claims" tabindex="0" role="region" aria-labelledby="table-claims-caption">
<table class="checks claims">
<caption id="table-claims-caption"><span>Each claim on the paper's joint and on this one</span></caption>
<thead><tr><th scope="col">Claim</th><th scope="col">Where</th><th scope="col">On the paper's joint</th><th scope="col">On this joint</th></tr></thead>
<tbody>
{{#CLAIM}}<tr><th scope="row"><bdi>{{WHAT:x-symbols}}</bdi></th><td class="text" data-name="where">{{WHERE}}</td><td class="text {{PAPERS_STATE}}" data-name="paper's joint"><strong>{{PAPERS_OUTCOME}}</strong>: {{PAPERS_FOUND:x-symbols}}</td><td class="text {{STATE}}" data-name="this joint"><strong>{{OUTCOME_HERE}}</strong>: {{FOUND:x-symbols}}</td></tr>
{{/CLAIM}}</tbody>
</table>
</div>
<p>The paper's joint is the one that gives its table 2, simulated without noise. A claim that the joint's experiments do not answer is not asked.</p>
</section>
<section id="figures" class="stage" aria-labelledby="figures-title">
<h2 id="figures-title">Figures <a class="self" href="#figures" aria-label="Link to this section">#</a></h2>
{{>FIGURE}}
</section>
<section id="selection" class="stage" aria-labelledby="selection-title">
<h2 id="selection-title">Masses, curves, choice <a class="self" href="#selection" aria-label="Link to this section">#</a></h2>
{{>TABLE}}
</section>
<section id="scenario" class="stage" aria-labelledby="scenario-title">
<h2 id="scenario-title">The joint that is simulated <a class="self" href="#scenario" aria-label="Link to this section">#</a></h2>
<details><summary><code>{{FILE_NAME}}</code></summary>
<pre class="command">{{FILE_TEXT}}</pre>
</details>
</section>
{{>PROVENANCE}}
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all claims as JSON are embedded in this file, in the element <code>tribolog-claims</code></p></footer>
<script type="application/json" id="tribolog-claims">{{RESULT_JSON:x-json}}</script>
</body>
</html>
