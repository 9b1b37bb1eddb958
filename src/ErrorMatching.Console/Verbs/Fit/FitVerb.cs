using System.CommandLine;
using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary>A verb that fits something to the columns x and y of a file.</summary>
internal abstract class FitVerb : Verb
{
    private readonly Argument<string> _points = new("POINTS.csv")
    {
        Description = "A header with x and y (x_mm and y_mm will do; other columns are ignored), then one line per point."
    };

    protected FitVerb(string name, string description, string example)
        : base(name, description, example) => Arguments.Add(_points);

    public sealed override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_points);
        var table = Numbers(file, "x", "y");
        cancellation.ThrowIfCancellationRequested();
        try
        {
            return Fit(table, arguments);
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, StandardInput.NameOf(file));
        }
    }

    /// <summary>Computes the fit.</summary>
    /// <param name="table">The columns <c>x</c> and <c>y</c>.</param>
    /// <param name="arguments">What the user typed.</param>
    /// <exception cref="GeometryException">The points do not determine the fit.</exception>
    protected abstract VerbResult Fit(NumberTable table, ParseResult arguments);

    /// <summary>The points of a table as doubles.</summary>
    protected static IReadOnlyList<Point2> PointsOf(NumberTable table) =>
        [.. table["x"].Zip(table["y"], (x, y) => new Point2(Number(x), Number(y)))];

    private static double Number(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
}
