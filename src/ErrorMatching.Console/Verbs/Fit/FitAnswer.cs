using System.Globalization;
using System.Text.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The common part of every fit's answer: the file, the number of points, the residuals and how well the points determine the
/// result.</summary>
internal abstract class FitAnswer(NumberTable table, IReadOnlyList<double> residuals, double residualStandardDeviation, double condition)
    : DocumentAnswer
{
    /// <summary>The fitted points.</summary>
    protected NumberTable Table => table;

    public sealed override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", table.File);
        json.WriteNumber("count", table.Count);
        WriteFit(json);
        json.Number("residualStandardDeviation", residualStandardDeviation);
        json.Numbers("residuals", residuals);
        json.Number("condition", condition);
    }

    public sealed override void WriteText(Page page)
    {
        page.Heading(string.Create(CultureInfo.InvariantCulture, $"{Title}, {ReportNumber.Count(table.Count, "point")} of {table.File}"));
        page.Line();
        WriteFit(page);
        page.Line();
        page.Facts(
            [("residual standard deviation", Show.Digits(residualStandardDeviation)), .. MoreFacts, ("condition", Show.Digits(condition))]);
        page.Line();
        page.Table(
            ["line", "x", "y", "residual"],
            residuals.Select(
                (r, i) => (IReadOnlyList<string>)[
                    table.Lines[i].ToString(CultureInfo.InvariantCulture), table["x"][i], table["y"][i], Show.Digits(r)]));
    }

    /// <summary>The heading: what was fitted.</summary>
    protected abstract string Title { get; }

    /// <summary>Statistics of this kind of fit only.</summary>
    protected virtual IReadOnlyList<(string Name, string Value)> MoreFacts => [];

    /// <summary>Writes the members of this kind of fit.</summary>
    protected abstract void WriteFit(Utf8JsonWriter json);

    /// <summary>Writes the result of this kind of fit.</summary>
    protected abstract void WriteFit(Page page);
}
