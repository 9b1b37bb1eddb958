using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A tool path in a report. Lengths in millimeters.</summary>
/// <param name="Passes">Number of passes.</param>
/// <param name="Points">Number of points.</param>
/// <param name="LengthMm">Its length.</param>
/// <param name="ChordMm">The largest chordal error found.</param>
/// <param name="ScallopMm">The largest scallop.</param>
/// <param name="GougeMm">How far the ball gouges beyond what is allowed, at most.</param>
/// <param name="RaisedPoints">Number of points raised because the ball does not fit.</param>
/// <param name="RaisedMm">The largest amount by which they were raised.</param>
public sealed record ToolPathFigures(
    int Passes, int Points, double LengthMm, double ChordMm, double ScallopMm, double GougeMm, int RaisedPoints, double RaisedMm)
{
    /// <summary>The figures of a path.</summary>
    public static ToolPathFigures Of(ToolPath path)
    {
        ArgumentNullException.ThrowIfNull(path);
        var certificate = path.Certificate;
        return new(
            path.Passes,
            path.Points,
            path.LengthMm,
            certificate.ChordMm,
            certificate.ScallopMm,
            certificate.GougeMm,
            certificate.RaisedPoints,
            certificate.RaisedMm);
    }

    /// <summary>Writes them into the open object.</summary>
    internal void Write(ReportWriter json)
    {
        json.Count("passes", Passes);
        json.Count("points", Points);
        json.Number("lengthMm", LengthMm);
        json.Number("chordUm", ChordMm * 1000);
        json.Number("scallopUm", ScallopMm * 1000);
        json.Number("gougeUm", GougeMm * 1000);
        json.Count("raisedPoints", RaisedPoints);
        json.Number("raisedUm", RaisedMm * 1000);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ToolPathFigures Read(ReportReader json) => new(
        json.Count("passes"),
        json.Count("points"),
        json.Number("lengthMm"),
        json.Micrometers("chordUm"),
        json.Micrometers("scallopUm"),
        json.Micrometers("gougeUm"),
        json.Count("raisedPoints"),
        json.Micrometers("raisedUm"));
}
