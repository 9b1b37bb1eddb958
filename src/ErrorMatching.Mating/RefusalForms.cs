using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The forms of refusals that a cell records, each named by the refusal's code.</summary>
public static class RefusalForms
{
    /// <summary>Point, feature, deviation and the job's limit, in mm.</summary>
    public static SentenceForm ImplausibleDeviation { get; } = new(
        "implausible-deviation",
        "Point {0} of {1} is {2:0.000} mm off, more than the {3:0.###} mm that are plausible: check part, probe and files before raising "
            + "\"limitMm\".");

    /// <summary>Block, feature, displacement and the job's limit, in mm.</summary>
    public static SentenceForm ImplausibleCourse { get; } = new(
        "implausible-course",
        "{0}: through the corrections at the points of {1} it would move by {2:0.000} mm, more than the {3:0.###} mm that are plausible, "
            + "though no point does. Measure nearer to the ends of the feature and at more points, or fix a lower \"degree\".");

    /// <summary>Feature, its limit, the largest deviation of its points, and that limit read as micrometers, in mm.</summary>
    public static SentenceForm LimitImplausible { get; } = new(
        "limit-implausible",
        "The limits of {0} allow {1:0.####} mm, and no point of it is more than {2:0.0000} mm off: are they in µm, "
        + "which would be {3:0.######} mm? State limits that the piece could miss.");

    /// <summary>Measurement, ratio of its point distances to the theoretical ones, and its file.</summary>
    public static SentenceForm UnitDiffers { get; } = new(
        "unit-differs",
        "{0}: its points lie {1:0.####} times as far apart as those of {2}. Is one of the two in inch? "
        + "Give \"unit\" in the gauge's \"format\", or export mm.");

    /// <summary>The theoretical points' file, and the columns as which a measurement's would fit it (<see
    /// cref="AxisOrder.Name"/>).</summary>
    public static SentenceForm ColumnsDiffer { get; } = new(
        "columns-differ",
        "The points lie where {0} has them only if the coordinates are read as {1}: are columns exchanged, or does an axis point the other "
        + "way? Name the columns in the gauge's \"format\", or export the file again.");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
        [ImplausibleDeviation, ImplausibleCourse, LimitImplausible, UnitDiffers, ColumnsDiffer];

    /// <summary>A refusal as a statement, without its place; its message as words if its code has no form.</summary>
    /// <param name="refusal">The refusal.</param>
    public static Statement StatementOf(Refusal refusal)
    {
        ArgumentNullException.ThrowIfNull(refusal);
        return All.FirstOrDefault(f => f.Name == refusal.Code && f.Kinds.Count == refusal.Values.Count) is { } form
            ? form.With([.. refusal.Values])
            : refusal.Message;
    }

    internal static Refusal Refusal(SentenceForm form, InputPlace place, params ReadOnlySpan<object?> values)
    {
        var statement = form.With(values);
        return new(form.Name, statement.Sentence, place) { Values = [.. statement.Values.Select(v => v.Sentence)] };
    }
}
