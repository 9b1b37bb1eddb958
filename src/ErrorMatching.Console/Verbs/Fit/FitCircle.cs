using System.CommandLine;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary><c>errormatch fit circle</c>.</summary>
internal sealed class FitCircle : FitVerb
{
    public FitCircle()
        : base(
            "circle",
            "Fits a circle to points by least squares of their distances from it.",
            "errormatch fit circle samples/fits/circle.csv")
    {
    }

    protected override VerbResult Fit(NumberTable table, ParseResult arguments) =>
        new FitCircleAnswer(table, CircleFit.Fit(PointsOf(table)));
}

/// <summary>A fitted circle.</summary>
internal sealed class FitCircleAnswer(NumberTable table, CircleFit fit)
    : FitAnswer(table, fit.Residuals, fit.ResidualStandardDeviation, fit.Condition)
{
    public override string Schema => "errormatch/fit-circle/1";

    protected override string Title => "Circle by geometric least squares";

    protected override void WriteFit(Utf8JsonWriter json)
    {
        json.Point("center", fit.Circle.Center);
        json.Pair("centerStandardError", fit.CenterStandardError.X, fit.CenterStandardError.Y);
        json.Number("radius", fit.Circle.Radius);
        json.Number("radiusStandardError", fit.RadiusStandardError);
    }

    protected override void WriteFit(Page page) => page.Table(
        ["", "value", "standard error"],
        [
            ["center x", Show.Mm(fit.Circle.Center.X), Show.Digits(fit.CenterStandardError.X)],
            ["center y", Show.Mm(fit.Circle.Center.Y), Show.Digits(fit.CenterStandardError.Y)],
            ["radius", Show.Mm(fit.Circle.Radius), Show.Digits(fit.RadiusStandardError)],
        ]);
}
