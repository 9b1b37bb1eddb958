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
        Description = "The degree, or auto for the one whose error over the whole curve is expected to be the least.",
        HelpName = "N|auto",
        Required = true,
    };

    private readonly Option<string> _ridge = new("--ridge")
    {
        Description = "The weight that damps high degrees: 0 for plain least squares, auto for the one that predicts left-out points best.",
        HelpName = "0|auto|W",
        DefaultValueFactory = _ => "0",
    };

    private readonly Option<string> _uncertainty = new("--uncertainty")
    {
        Description = "The gauge's standard uncertainty of y, if known: it tells noise from shape and enters the standard errors.",
        HelpName = "U",
    };

    private readonly Option<string> _at = new("--at")
    {
        Description = "Places x to evaluate the polynomial at.",
        HelpName = "X[,X...]",
    };

    public FitPolynomial()
        : base("polynomial", "Fits a polynomial y(x) to points.", "errormatch fit polynomial samples/fits/curve.csv --degree auto")
    {
        _degree.CompletionSources.Add(Auto);
        _ridge.CompletionSources.Add(Auto, "0");
        Options.Add(_degree);
        Options.Add(_ridge);
        Options.Add(_uncertainty);
        Options.Add(_at);
        Demand(_degree, text => DegreeOf(text) is not null, $"auto or a whole number from 0 to {HighestDegree}");
        Demand(_ridge, text => RidgeOf(text) is not null, "auto or a number that is not negative");
        Demand(_uncertainty, text => Positive(text) is not null, "a positive number");
        Demand(_at, text => Places(text) is not null, "numbers with commas between them");
    }

    protected override VerbResult Fit(NumberTable table, ParseResult arguments)
    {
        var (degree, ridge) = (arguments.GetRequiredValue(_degree), arguments.GetRequiredValue(_ridge));
        var options = new PolynomialFitOptions
        {
            Degree = degree == Auto ? null : DegreeOf(degree),
            Ridge = ridge == Auto ? null : RidgeOf(ridge),
            PointUncertaintyMm = arguments.GetValue(_uncertainty) is { } uncertainty ? Positive(uncertainty)!.Value : 0,
        };
        var fit = PolynomialFit.Fit(Exact(table["x"]), Exact(table["y"]), options);
        return new FitPolynomialAnswer(
            table, fit, options.PointUncertaintyMm, arguments.GetValue(_at) is { } places ? Places(places)! : []);
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
            : Finite(text) is >= 0 and var weight ? weight : null;

    private static double? Positive(string text) => Finite(text) is > 0 and var number ? number : null;

    private static double[]? Places(string text)
    {
        var places = Array.ConvertAll(text.Split(','), Finite);
        return places.All(p => p is not null) ? Array.ConvertAll(places, p => p!.Value) : null;
    }

    private static double? Finite(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : null;
}
