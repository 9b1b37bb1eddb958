using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>Texts on the result of taking a table of coordinates.</summary>
internal static class TableText
{
    // Enough of a line to recognize it, and enough labels and features to know which ones are meant.
    private const int MostShown = 60, MostLabels = 12, MostFeatures = 6, MostRefused = 4;

    /// <summary>Why nothing was taken from a table, and what to do; null if it was taken.</summary>
    /// <param name="table">The table.</param>
    /// <param name="taken">The result.</param>
    public static Func<string>? Refused(PointTable table, TakenTable taken) => table switch
    {
        { Fault: { } fault } =>
            () => Texts.Current.With(
                "System.BadRow", fault.Line, fault.Text.Length > MostShown ? fault.Text[..MostShown] + "…" : fault.Text),
        { Count: 0 } => () => Texts.Current["System.NoCoordinates"],
        _ => taken.Refusal switch
        {
            PointTableRefusal.NoFeatures => () => Texts.Current["System.NoFeatures"],
            PointTableRefusal.LabelTwice => () => Texts.Current.With("System.TableTwice", Listed(taken.OnlyInTable)),
            PointTableRefusal.NoLabels => () => Texts.Current.With("System.TableNoLabels", taken.Rows, taken.Points),
            PointTableRefusal.OtherCount => () => Sentence.Joined(
                Texts.Current.With("System.TableCount", taken.Rows, taken.Points),
                taken.OnlyInTable.Count > 0 ? Texts.Current.With("System.OnlyInTable", Listed(taken.OnlyInTable, MostRefused)) : "",
                taken.OnlyInFeatures.Count > 0
                    ? Texts.Current.With("System.OnlyInFeatures", Listed(taken.OnlyInFeatures, MostRefused))
                    : "",
                Texts.Current["System.TableCountNext"]),
            _ => null,
        },
    };

    /// <summary>What was taken from a table, and the differences between table and features.</summary>
    /// <param name="table">The table.</param>
    /// <param name="taken">The result.</param>
    public static string Taken(PointTable table, TakenTable taken) => Sentence.Joined(
        Texts.Current.With("System.Table", table.Count),
        taken.HasNewLabels
            ? Texts.Current.With(
                "System.TableLabels", Listed([.. taken.Draft.Features.Where(f => f.Points.Any()).Select(LabelsOf)], MostFeatures))
            : "",
        taken.OnlyInTable.Count > 0 ? Texts.Current.With("System.TableOther", Listed(taken.OnlyInTable)) : "",
        taken.OnlyInFeatures.Count > 0 ? Texts.Current.With("System.TableMissing", Listed(taken.OnlyInFeatures)) : "");

    /// <summary>The first words of a list, at most <paramref name="most"/>.</summary>
    public static string Listed(IReadOnlyList<string> words, int most = MostLabels) =>
        Texts.Current.Listed(words.Take(most)) + (words.Count > most ? " …" : "");

    private static string LabelsOf(FeatureDraft feature) =>
        Texts.Current.With("System.LabelsOf", feature.Name, feature.Points.First().Label, feature.Points.Last().Label);
}
