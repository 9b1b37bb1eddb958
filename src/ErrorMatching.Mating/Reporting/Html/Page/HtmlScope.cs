namespace ErrorMatching.Mating;

/// <summary>An open element, closed at the end of the scope.</summary>
internal readonly ref struct HtmlScope(HtmlText html, string element)
{
    public void Dispose() => html.End(element);
}
