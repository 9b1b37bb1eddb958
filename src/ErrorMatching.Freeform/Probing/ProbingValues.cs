using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>The values that a template's places stand for, as a control reads them.</summary>
internal sealed class ProbingValues(MeasuringPlan plan, string job, NcDialect dialect)
{
    /// <summary>The way to a point and back is this many times as fast as measuring.</summary>
    private const double ApproachSpeed = 10;

    public static readonly string[] OfProgram = ["job", "plan", "count", "clearance.z", "feed.measuring", "feed.approach", "stylus.diameter", "overtravel.mm", "approach.mm"];

    public static readonly string[] OfPoint =
        ["point", "i", "j", "approach.x", "approach.y", "approach.z", "contact.x", "contact.y", "contact.z", "center.x", "center.y", "center.z", "overtravel.x", "overtravel.y", "overtravel.z"];

    public string this[string place, PlanPoint? point] => place switch
    {
        "job" => Plain(job),
        "plan" => ProbingProgram.PlanId(plan),
        "count" => plan.Points.Count.ToString(CultureInfo.InvariantCulture),
        "clearance.z" => Mm(plan.ClearanceZ, up: true),
        "feed.measuring" => Mm(plan.Measuring.FeedMmPerMin),
        "feed.approach" => Mm(plan.Measuring.FeedMmPerMin * ApproachSpeed),
        "stylus.diameter" => Mm(plan.Measuring.StylusDiameterMm),
        "overtravel.mm" => Mm(plan.Measuring.OvertravelMm),
        "approach.mm" => Mm(plan.Measuring.ApproachMm),
        _ => OfOne(place, point!),
    };

    /// <summary>Whether a condition holds.</summary>
    public bool Holds(string condition, PlanPoint? point, bool merged) => condition switch
    {
        ProbingTemplate.Merged => merged,
        ProbingTemplate.AlongAxis => AxisOf(point!) is not null,
        _ => AxisOf(point!) == condition[^1],
    };

    // The axis that the measuring move is along: the other coordinates stay within half an increment.
    private char? AxisOf(PlanPoint point)
    {
        var half = 0.5 * Math.Pow(10, -dialect.MetricDecimals) / (plan.Measuring.ApproachMm + plan.Measuring.OvertravelMm);
        var (x, y, z) = (Math.Abs(point.Normal.X) <= half, Math.Abs(point.Normal.Y) <= half, Math.Abs(point.Normal.Z) <= half);
        return (x, y, z) switch { (false, true, true) => 'x', (true, false, true) => 'y', (true, true, false) => 'z', _ => null };
    }

    private string OfOne(string place, PlanPoint point)
    {
        if (place is "point" or "i" or "j")
        {
            return (place == "point" ? point.Number : place == "i" ? point.I : point.J).ToString(CultureInfo.InvariantCulture);
        }

        var at = place[..^2] switch { "approach" => plan.ApproachOf(point), "contact" => plan.ContactOf(point), "center" => plan.CenterOf(point), _ => plan.OvertravelOf(point) };
        return Mm(place[^1] switch { 'x' => at.X, 'y' => at.Y, _ => at.Z });
    }

    // In least increments, with a point always: some controls count increments without one.
    private string Mm(double value, bool up = false)
    {
        var increments = Math.Pow(10, dialect.MetricDecimals);
        var rounded = up ? Math.Ceiling(Math.Round(value * increments, 3)) / increments : Math.Round(value, dialect.MetricDecimals);
        return (rounded + 0.0).ToString("0.0" + new string('#', dialect.MetricDecimals - 1), CultureInfo.InvariantCulture);
    }

    // Names go into comments and messages: nothing in them may end one.
    private static string Plain(string name)
    {
        var text = new StringBuilder();
        foreach (var c in name.Length <= 40 ? name : name[..40])
        {
            text.Append(char.IsAsciiLetterOrDigit(c) || c is ' ' or '-' or '.' ? c : '_');
        }

        return text.ToString();
    }
}
