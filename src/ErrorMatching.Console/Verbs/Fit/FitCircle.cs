using System.CommandLine;
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
