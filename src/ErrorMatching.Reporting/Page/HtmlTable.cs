namespace ErrorMatching.Reporting;

/// <summary>Writes tables with caption and headings, in their own region that scrolls in a small window, with the keyboard too.</summary>
public static class HtmlTable
{
    /// <summary>Writes a table.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Its identifier on the page.</param>
    /// <param name="caption">Its caption.</param>
    /// <param name="columns">Its columns.</param>
    /// <param name="rows">Its rows.</param>
    /// <param name="cells">Writes the cells of one row.</param>
    /// <param name="isLong">True if it may be too long for a screen; its headings then stay while the rows scroll.</param>
    public static void Write<T>(
        HtmlText html,
        string id,
        string caption,
        IReadOnlyList<TableColumn> columns,
        IEnumerable<T> rows,
        Action<TableRow, T> cells,
        bool isLong = false)
    {
        using (html.In("div", ("class", isLong ? "scroll long" : "scroll"), ("role", "region"), ("tabindex", "0"), ("aria-labelledby", id)))
        using (html.In("table"))
        {
            html.Put("caption", caption, ("id", id));
            WriteHead(html, columns);
            using (html.In("tbody"))
            {
                var row = new TableRow(html);
                foreach (var item in rows)
                {
                    using (html.In("tr"))
                    {
                        cells(row, item);
                    }
                }
            }
        }
    }

    private static void WriteHead(HtmlText html, IReadOnlyList<TableColumn> columns)
    {
        var grouped = columns.Any(c => c.Group is not null);
        using (html.In("thead"))
        {
            using (html.In("tr"))
            {
                for (var i = 0; i < columns.Count; i++)
                {
                    if (columns[i].Group is not { } group)
                    {
                        WriteHead(html, columns[i], grouped ? "2" : null);
                    }
                    else if (i == 0 || columns[i - 1].Group != group)
                    {
                        var span = columns.Skip(i).TakeWhile(c => c.Group == group).Count();
                        html.Put("th", group, ("scope", "colgroup"), ("colspan", ReportNumber.Count(span)), ("class", "group"));
                    }
                }
            }

            if (grouped)
            {
                using (html.In("tr"))
                {
                    foreach (var column in columns.Where(c => c.Group is not null))
                    {
                        WriteHead(html, column, null);
                    }
                }
            }
        }
    }

    private static void WriteHead(HtmlText html, TableColumn column, string? rows) =>
        html.Put("th", column.Title, ("scope", "col"), ("rowspan", rows), ("class", column.IsNumber ? "num" : null));
}
