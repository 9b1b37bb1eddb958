using System.CommandLine;
using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary><c>errormatch fit polynomial</c>.</summary>
internal sealed class FitPolynomial : FitVerb
{
    private const string Auto = "auto";
    private const int HighestDegree = 100;

    private readonly Option<string> _degree = new("--degree")
    {
        Description = "The degree, or auto for the one that predicts left-out points best.",
        HelpName = "N|auto",
        Required = true,
    };

    private readonly Option<string> _ridge = new("--ridge")
    {
        Description = "The weight that damps high degrees: 0 for plain least squares, auto for the one that predicts left-out points best.",
        HelpName = "0|auto|W",
        DefaultValueFactory = _ => "0",
    };

    public FitPolynomial()
        : base("polynomial", "Fits a polynomial y(x) to points.", "errormatch fit polynomial samples/fits/curve.csv --degree auto")
    {
        Options.Add(_degree);
        Options.Add(_ridge);
        Demand(_degree, text => DegreeOf(text) is not null, $"auto or a whole number from 0 to {HighestDegree}");
        Demand(_ridge, text => RidgeOf(text) is not null, "auto or a number that is not negative");
    }

    protected override VerbResult Fit(NumberTable table, ParseResult arguments)
    {
        var (degree, ridge) = (arguments.GetRequiredValue(_degree), arguments.GetRequiredValue(_ridge));
        var options = new PolynomialFitOptions
        {
            Degree = degree == Auto ? null : DegreeOf(degree),
            Ridge = ridge == Auto ? null : RidgeOf(ridge)
        };
        return new FitPolynomialAnswer(table, PolynomialFit.Fit(Exact(table["x"]), Exact(table["y"]), options));
    }

    private static IReadOnlyList<DoubleDouble> Exact(IReadOnlyList<string> texts) => [.. texts.Select(t => DoubleDouble.Parse(t))];

    // The word auto gives zero for both; the code that builds the fit's options explains it.
    private static int? DegreeOf(string text) =>
        text == Auto
            ? 0
            : int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var degree) && degree <= HighestDegree
            ? degree
            : null;

    private static double? RidgeOf(string text) =>
        text == Auto
            ? 0
            : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var weight)
                && double.IsFinite(weight)
                && weight >= 0
            ? weight
            : null;
}
