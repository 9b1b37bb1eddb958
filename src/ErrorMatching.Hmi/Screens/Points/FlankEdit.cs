using System.Globalization;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The number of points of a feature, or of one of its flanks.</summary>
internal sealed class FlankEdit : Observable
{
    private const int Most = 1000;
    private readonly int _feature;
    private readonly int _flank;
    private readonly bool _isOne;

    public FlankEdit(JobEditing editing, int feature, int flank)
    {
        ArgumentNullException.ThrowIfNull(editing);
        (_feature, _flank, _isOne) = (feature, flank, editing.Draft.Features[feature].Flanks.Count == 1);
        var path = DraftPaths.Feature(feature, FeatureDraft.PointsKey)
            + (_isOne ? "" : string.Create(CultureInfo.InvariantCulture, $"[{flank}]"));
        Count = new(
            editing,
            path,
            _isOne
                ? "Points.Count"
                : string.Create(CultureInfo.InvariantCulture, $"Points.Count.{editing.Draft.Features[feature].Kind}.{flank + 1}"),
            d => CountOf(d).ToString(CultureInfo.InvariantCulture),
            (d, t) => IsCount(t, out var count) ? d.WithPoints(feature, flank, count) : d,
            t => IsCount(t, out _) ? null : "not-a-count")
        {
            Row = () => FeatureEdit.NameOf(editing, feature),
        };
        Less = new(
            () => editing.Change("", d => d.WithPoints(feature, flank, CountOf(d) - 1)),
            () => editing.CanEdit && CountOf(editing.Draft) > 0);
        More = new(
            () => editing.Change("", d => d.WithPoints(feature, flank, CountOf(d) + 1)),
            () => editing.CanEdit && CountOf(editing.Draft) < Most);
    }

    public TextField Count { get; }

    public Command Less { get; }

    public Command More { get; }

    public string LessId => string.Create(CultureInfo.InvariantCulture, $"feature-{_feature}-flank-{_flank}-less");

    public string MoreId => string.Create(CultureInfo.InvariantCulture, $"feature-{_feature}-flank-{_flank}-more");

    /// <summary>Updates the commands.</summary>
    internal void Refresh()
    {
        Less.Refresh();
        More.Refresh();
    }

    private static bool IsCount(string text, out int count) =>
        int.TryParse(text.Trim(), NumberStyles.None, CultureInfo.InvariantCulture, out count) && count <= Most;

    private int CountOf(MatingDraft draft) =>
        _feature < draft.Features.Count && _flank < draft.Features[_feature].Flanks.Count
            ? draft.Features[_feature].Flanks[_flank].Count
            : 0;
}
