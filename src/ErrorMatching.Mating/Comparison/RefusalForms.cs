using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Sentences of refusals that a cell records; each is named by the refusal's code.</summary>
public static class RefusalForms
{
    /// <summary>Point, feature, how far it is off and the job's limit, in mm.</summary>
    public static SentenceForm ImplausibleDeviation { get; } = new(
        Decider.ImplausibleDeviation, "Point {0} of {1} is {2:0.000} mm off, more than the {3:0.###} mm that are plausible: check part, probe and files before raising \"limitMm\".");

    /// <summary>Block, feature, how far it would move and the job's limit, in mm.</summary>
    public static SentenceForm ImplausibleCourse { get; } = new(
        "implausible-course",
        "{0}: through the corrections at the points of {1} it would move by {2:0.000} mm, more than the {3:0.###} mm that are plausible, though no point does. Measure nearer to the ends of the feature and at more points, or fix a lower \"degree\".");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [ImplausibleDeviation, ImplausibleCourse];
}
