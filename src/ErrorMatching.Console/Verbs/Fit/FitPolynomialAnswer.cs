using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A fitted polynomial, and its values at the places that were asked for.</summary>
internal sealed class FitPolynomialAnswer(NumberTable table, PolynomialFit fit, double uncertainty, IReadOnlyList<double> at)
    : FitAnswer(table, fit.Residuals, fit.ResidualStandardDeviation, fit.Condition)
{
    /// <summary>Place, and the least and the largest x of the points.</summary>
    private static readonly SentenceForm OutsidePoints = new(
        "outside-points",
        "x = {0} is outside the points, which extend from {1} to {2}. The polynomial is not known there: do not use the value.");

    /// <summary>Number of coefficients.</summary>
    private static readonly SentenceForm NothingLeft = new(
        "nothing-left",
        "There are as many coefficients as points ({0}), so the points do not show how wrong they are: the standard errors are 0 but not "
            + "known. State the gauge's uncertainty with --uncertainty.");

    private readonly double _first = NumbersOf(table["x"]).Min();
    private readonly double _last = NumbersOf(table["x"]).Max();

    public override string Schema => "errormatch/fit-polynomial/1";

    protected override string Title =>
        string.Create(CultureInfo.InvariantCulture, $"Polynomial of degree {fit.Degree}, ridge weight {fit.Ridge}");

    protected override IReadOnlyList<(string Name, string Value)> MoreFacts =>
    [
        ("leave-one-out error (RMS)", fit.LeaveOneOutRms is { } rms ? Show.Digits(rms) : "none: each point determines its own value"),
        ("known between", $"x = {Show.Exact(_first)} and {Show.Exact(_last)}"),
    ];

    protected override void WriteFit(Utf8JsonWriter json)
    {
        json.WriteNumber("degree", fit.Degree);
        json.Number("ridge", fit.Ridge);
        json.Numbers("coefficients", fit.Coefficients);
        json.Numbers("standardErrors", fit.StandardErrors);
        json.Number("effectiveDegreesOfFreedom", fit.EffectiveDegreesOfFreedom);
        json.Number("leaveOneOutRms", fit.LeaveOneOutRms ?? double.NaN);
        json.Numbers("extent", [_first, _last]);
        json.WriteStartArray("values");
        foreach (var x in at)
        {
            json.WriteStartObject();
            json.Number("x", x);
            json.Number("y", fit.Evaluate(x));
            json.Number("standardError", fit.StandardErrorAt(x));
            json.WriteBoolean("outside", IsOutside(x));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        new ReportWriter(json).Warnings([.. Warnings()]);
    }

    protected override void WriteFit(Page page)
    {
        foreach (var warning in Warnings())
        {
            page.Warning(warning.Message);
        }

        page.Table(
            ["power of x", "coefficient", "standard error"],
            fit.Coefficients.Select(
                (c, i) => (IReadOnlyList<string>)[
                    i.ToString(CultureInfo.InvariantCulture), Show.Exact(c), Show.Digits(fit.StandardErrors[i])]));
        if (at.Count > 0)
        {
            page.Line();
            page.Table(
                ["at x", "y", "standard error", ""],
                at.Select(x => (IReadOnlyList<string>)
                [
                    Show.Exact(x), Show.Digits(fit.Evaluate(x)), Show.Digits(fit.StandardErrorAt(x)),
                    IsOutside(x) ? "outside the points" : "",
                ]));
        }
    }

    private static IEnumerable<double> NumbersOf(IReadOnlyList<string> texts) =>
        texts.Select(t => double.Parse(t, NumberStyles.Float, CultureInfo.InvariantCulture));

    private bool IsOutside(double x) => x < _first || x > _last;

    private IEnumerable<ReportWarning> Warnings()
    {
        if (fit.EffectiveDegreesOfFreedom >= fit.Residuals.Count && uncertainty == 0)
        {
            yield return Warning(NothingLeft, (fit.Degree + 1).ToString(CultureInfo.InvariantCulture));
        }

        foreach (var x in at.Where(IsOutside))
        {
            yield return Warning(OutsidePoints, Show.Exact(x), Show.Exact(_first), Show.Exact(_last));
        }
    }

    private static ReportWarning Warning(SentenceForm form, params string[] values) => new(form.Name, form.With(values).Sentence, values);
}
