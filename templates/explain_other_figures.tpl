{{%AUTOESCAPE context="HTML"}}
<p class="explain">Figures that belong to no single stage.</p>
