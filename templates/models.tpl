{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Friction models side by side</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<header class="page-head">
<p class="kicker">{{TOOL}} · friction models</p>
<h1>Friction models side by side</h1>
<p class="subtitle">The dynamic models of the literature in four experiments, each with parameters that match the same contact. LuGre's curve is overlaid on each of the others in thin dashes.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#models">The models</a></li>
{{#CONTENTS_ENTRY}}<li><a href="#{{SECTION_ID}}">{{TITLE}}</a></li>
{{/CONTENTS_ENTRY}}
</ol>
</nav>
<main id="content">
<section id="models" aria-labelledby="models-title">
<h2 id="models-title">The models <a class="self" href="#models" aria-label="Link to this section">#</a></h2>
{{>TABLE}}
</section>
{{#EXPERIMENT}}<section id="{{SECTION_ID}}" class="stage" aria-labelledby="{{SECTION_ID}}-title">
<h2 id="{{SECTION_ID}}-title">{{TITLE}} <a class="self" href="#{{SECTION_ID}}" aria-label="Link to this section">#</a></h2>
<p>{{EXPLANATION}}</p>
<div class="side-by-side">
{{>FIGURE}}
</div>
</section>
{{/EXPERIMENT}}
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}}</p></footer>
</body>
</html>
