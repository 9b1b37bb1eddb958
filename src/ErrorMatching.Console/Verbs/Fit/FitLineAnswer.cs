using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary>A fitted line.</summary>
internal sealed class FitLineAnswer(NumberTable table, string method, LineFit fit)
    : FitAnswer(table, fit.Residuals, fit.ResidualStandardDeviation, fit.Condition)
{
    public override string Schema => "errormatch/fit-line/1";

    protected override string Title => $"Line by {(method == "ols" ? "ordinary" : "total")} least squares";

    private Angle Direction => fit.Line.Direction.Direction;

    protected override void WriteFit(Utf8JsonWriter json)
    {
        json.WriteString("method", method);
        json.Point("centroid", fit.Centroid);
        json.Pair("direction", fit.Line.Direction.X, fit.Line.Direction.Y);
        json.Number("angleDeg", Direction.Degrees);
        json.Number("angleStandardErrorDeg", fit.AngleStandardError.Degrees);
        json.Number("offsetStandardError", fit.OffsetStandardError);
        json.Point("from", fit.Extent.Start);
        json.Point("to", fit.Extent.End);
        json.Number("length", fit.Length);
        if (fit.Equation is { } equation)
        {
            json.Number("intercept", equation.Intercept);
            json.Number("interceptStandardError", equation.InterceptStandardError);
            json.Number("slope", equation.Slope);
            json.Number("slopeStandardError", equation.SlopeStandardError);
        }
    }

    protected override void WriteFit(Page page)
    {
        page.Table(
            ["", "value", "standard error"],
            [
                ["centroid x", Show.Mm(fit.Centroid.X), ""],
                ["centroid y", Show.Mm(fit.Centroid.Y), ""],
                ["offset across", Show.Mm(0), Show.Digits(fit.OffsetStandardError)],
                ["direction in degrees", Show.Degrees(Direction.Degrees), Show.Digits(fit.AngleStandardError.Degrees)],
                ["length", Show.Mm(fit.Length), ""],
            ]);
        if (fit.Equation is { } equation)
        {
            page.Line();
            page.Table(
                ["y = a + b x", "value", "standard error"],
                [
                    ["a", Show.Exact(equation.Intercept), Show.Digits(equation.InterceptStandardError)],
                    ["b", Show.Exact(equation.Slope), Show.Digits(equation.SlopeStandardError)],
                ]);
        }
    }
}
