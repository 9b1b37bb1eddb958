using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary>A fitted polynomial.</summary>
internal sealed class FitPolynomialAnswer(NumberTable table, PolynomialFit fit)
    : FitAnswer(table, fit.Residuals, fit.ResidualStandardDeviation, fit.Condition)
{
    public override string Schema => "errormatch/fit-polynomial/1";

    protected override string Title =>
        string.Create(CultureInfo.InvariantCulture, $"Polynomial of degree {fit.Degree}, ridge weight {fit.Ridge}");

    protected override IReadOnlyList<(string Name, string Value)> MoreFacts =>
        [("leave-one-out error (RMS)", fit.LeaveOneOutRms is { } rms ? Show.Digits(rms) : "none: each point determines its own value")];

    protected override void WriteFit(Utf8JsonWriter json)
    {
        json.WriteNumber("degree", fit.Degree);
        json.Number("ridge", fit.Ridge);
        json.Numbers("coefficients", fit.Coefficients);
        json.Numbers("standardErrors", fit.StandardErrors);
        json.Number("effectiveDegreesOfFreedom", fit.EffectiveDegreesOfFreedom);
        json.Number("leaveOneOutRms", fit.LeaveOneOutRms ?? double.NaN);
    }

    protected override void WriteFit(Page page) => page.Table(
        ["power of x", "coefficient", "standard error"],
        fit.Coefficients.Select(
            (c, i) => (IReadOnlyList<string>)[
                i.ToString(CultureInfo.InvariantCulture), Show.Exact(c), Show.Digits(fit.StandardErrors[i])]));
}
