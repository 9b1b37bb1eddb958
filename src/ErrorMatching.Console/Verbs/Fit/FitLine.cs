using System.CommandLine;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary><c>errormatch fit line</c>.</summary>
internal sealed class FitLine : FitVerb
{
    private const string Total = "tls";
    private const string Ordinary = "ols";

    private readonly Option<string> _method = new("--method")
    {
        Description = "Least squares of the distances across the line (tls) or of the distances in y (ols).",
        HelpName = "tls|ols",
        DefaultValueFactory = _ => Total,
    };

    public FitLine()
        : base("line", "Fits a straight line to points.", "errormatch fit line samples/fits/line.csv")
    {
        _method.AcceptOnlyFromAmong(Total, Ordinary);
        Options.Add(_method);
    }

    protected override VerbResult Fit(NumberTable table, ParseResult arguments)
    {
        var method = arguments.GetRequiredValue(_method);
        var points = PointsOf(table);
        return new FitLineAnswer(table, method, method == Ordinary ? LineFit.Ordinary(points) : LineFit.Total(points));
    }
}
