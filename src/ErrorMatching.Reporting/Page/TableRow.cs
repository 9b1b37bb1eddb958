namespace ErrorMatching.Reporting;

/// <summary>Writes the cells of a row.</summary>
public sealed class TableRow(HtmlText html)
{
    /// <summary>The cell that names the row.</summary>
    public void Header(string text) => html.Put("th", text, ("scope", "row"));

    /// <summary>A cell with text.</summary>
    public void Text(string text) => html.Put("td", text);

    /// <summary>A number, aligned at its decimal sign.</summary>
    public void Number(string text) => html.Put("td", text, ("class", "num"));

    /// <summary>Something of a program or a file name, letter by letter.</summary>
    public void Code(string text)
    {
        using (html.In("td"))
        {
            html.Put("code", text);
        }
    }

    /// <summary>A cell that holds more than text.</summary>
    public HtmlScope Cell(string? cssClass = null) => html.In("td", ("class", cssClass));
}
