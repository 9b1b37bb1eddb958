using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The values of a template's placeholders, as the control reads them.</summary>
internal sealed class ProbingValues(ProbingMoves moves, string job, string? order, NcDialect dialect, string template)
{
    private readonly CommentText _comments = new(dialect);

    /// <summary>Ratio of the feed to a point and back to the measuring feed.</summary>
    private const double ApproachSpeed = 10;

    public static readonly string[] OfProgram = [
        "job", "order", "plan", "count", "clearance.z", "feed.measuring", "feed.approach", "stylus.diameter", "overtravel.mm",
        "approach.mm", "cut.measurement", "assumed"];

    public static readonly string[] OfPoint =
        [
            "point", "i", "j", "name", "approach.x", "approach.y", "approach.z", "contact.x", "contact.y", "contact.z", "center.x",
            "center.y", "center.z", "overtravel.x", "overtravel.y", "overtravel.z", "angle", "start.mm", "surface.mm", "search.mm",
            "reach.mm"];

    public string this[string place, ProbingTouch? point, ProbedBehind? behind] => place switch
    {
        "job" => _comments.Of(job),
        "order" => _comments.Of(order ?? ""),
        "plan" => moves.Plan,
        "count" => moves.Touches.Count.ToString(CultureInfo.InvariantCulture),
        "clearance.z" => Coordinate(moves.ClearanceZ, up: true),
        "feed.measuring" => NotZero("feedMmPerMin", moves.FeedMmPerMin),
        "feed.approach" => NotZero("feedMmPerMin", moves.FeedMmPerMin * ApproachSpeed),
        "stylus.diameter" => NotZero("stylusDiameterMm", moves.StylusDiameterMm),
        "overtravel.mm" => NotZero("overtravelMm", moves.OvertravelMm),
        "approach.mm" => NotZero("approachMm", moves.ApproachMm),
        "cut.measurement" => behind?.MeasurementSha256 ?? "",
        "assumed" => _comments.Of(Shortened(string.Join(", ", moves.Assumed))),
        _ when TemplateGrammar.ToolPlaces.Contains(place, StringComparer.Ordinal) => moves.Tool!.ValueOf(place, template),
        _ => OfOne(place, point!),
    };

    public bool Holds(string condition, ProbingTouch? point, ProbedBehind? behind) => condition switch
    {
        ProbingTemplate.Merged => behind is not null,
        ProbingTemplate.Assumed => moves.Assumed.Count > 0,
        ProbingTemplate.Compensated => behind?.MeasurementSha256 is not null,
        TemplateGrammar.Order => !string.IsNullOrWhiteSpace(order),
        ProbingTemplate.Grid => point!.Grid is not null,
        TemplateGrammar.Tool => moves.Tool is not null,
        TemplateGrammar.ToolByName => moves.Tool?.Name is not null,
        ProbingTemplate.AlongAxis => AxisOf(point!) is not null,
        ProbingTemplate.InPlane => Math.Abs(point!.Normal.Z) <= HalfIncrement,
        ProbingTemplate.TowardPlus => AxisOf(point!) switch { 'x' => point!.Normal.X, 'y' => point!.Normal.Y, _ => point!.Normal.Z } < 0,
        _ => AxisOf(point!) == condition[^1],
    };

    // Of a unit normal: half a least increment of the measuring move.
    private double HalfIncrement => 0.5 * Elementary.Pow(10, -dialect.MetricDecimals) / (moves.ApproachMm + moves.OvertravelMm);

    // The axis of the measuring move, if the other coordinates stay within half an increment.
    private char? AxisOf(ProbingTouch point)
    {
        var half = HalfIncrement;
        var (x, y, z) = (Math.Abs(point.Normal.X) <= half, Math.Abs(point.Normal.Y) <= half, Math.Abs(point.Normal.Z) <= half);
        return (x, y, z) switch { (false, true, true) => 'x', (true, false, true) => 'y', (true, true, false) => 'z', _ => null };
    }

    private string OfOne(string place, ProbingTouch point)
    {
        switch (place)
        {
            case "name":
                return _comments.Of(point.Name);
            case "point":
                return point.Number.ToString(CultureInfo.InvariantCulture);
            case "i" or "j":
                return (place == "i" ? point.Grid?.I : point.Grid?.J)?.ToString(CultureInfo.InvariantCulture) ?? "";
            case "angle":
                return Coordinate((new Vector2(-point.Normal.X, -point.Normal.Y).Direction).Degrees);
            case "start.mm" or "surface.mm" or "search.mm" or "reach.mm":
                var start = (point.Approach - point.Center).Length;
                return NotZero("approachMm", place switch
                {
                    "start.mm" => start,
                    "surface.mm" => start + (moves.StylusDiameterMm / 2),
                    "search.mm" => Math.Min(start, moves.OvertravelMm),
                    _ => start + moves.OvertravelMm,
                });
        }

        var at = place[..^2] switch
        {
            "approach" => point.Approach,
            "contact" => point.Contact,
            "center" => point.Center,
            _ => point.Overtravel,
        };
        return Coordinate(place[^1] switch { 'x' => at.X, 'y' => at.Y, _ => at.Z });
    }

    // A positive value of the job must not round to 0: at a feed of 0 the control stops, and a probe that does not move touches nothing.
    private string NotZero(string key, double value) =>
        Mm(value) is var text and not "0.0" ? text : throw InputException.At("rounds-to-zero", template, string.Create(
        CultureInfo.InvariantCulture,
        $"measuring.{key} would be written as 0: {value} is less than half of the least increment of {dialect.Name}, "
            + $"{Elementary.Pow(10, -dialect.MetricDecimals)}. A larger one is expected"));

    // A comment of the control has room for so much; the answer has all of it.
    private string Shortened(string assumed)
    {
        const int Around = 24;
        const string More = ", and more";
        var room = Math.Min(CommentText.MostOfName, dialect.CommentLength - Around);
        var end = assumed.Length <= room ? assumed.Length : assumed.LastIndexOf(", ", room - More.Length, StringComparison.Ordinal);
        return end == assumed.Length ? assumed : assumed[..(end < 0 ? room - More.Length : end)] + More;
    }

    // Klartext shows the sign of each coordinate.
    private string Coordinate(double value, bool up = false) =>
        Mm(value, up) is var text && !dialect.HasCodes && !text.StartsWith('-') ? "+" + text : text;

    // In least increments, always with a decimal point: without one, some controls count increments.
    private string Mm(double value, bool up = false)
    {
        var increments = Elementary.Pow(10, dialect.MetricDecimals);
        var rounded = up ? Math.Ceiling(Math.Round(value * increments, 3)) / increments : Math.Round(value, dialect.MetricDecimals);
        return (rounded + 0.0).ToString("0.0" + new string('#', dialect.MetricDecimals - 1), CultureInfo.InvariantCulture);
    }

    /// <summary>A line of the program with its comment as the control takes it.</summary>
    public string Line(string line) => _comments.Line(line);
}

/// <summary>The cutting program that a probing program follows in a merged file.</summary>
/// <param name="MeasurementSha256">The measurement that the cutting program followed, in capitals, or <see cref="Damaged"/>; null if it
/// carries no marker.</param>
internal sealed record ProbedBehind(string? MeasurementSha256)
{
    /// <summary>Replaces a hash that cannot be read.</summary>
    public const string Damaged = "DAMAGED";
}
