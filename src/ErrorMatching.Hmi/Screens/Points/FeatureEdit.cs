using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A feature in the point setup: its name, its kind and its numbers of points.</summary>
internal sealed class FeatureEdit : Observable
{
    private readonly JobEditing _editing;
    private readonly int _index;

    public FeatureEdit(JobEditing editing, int index)
    {
        (_editing, _index) = (editing ?? throw new ArgumentNullException(nameof(editing)), index);
        Kind = editing.Draft.Features[index].Kind;
        Name = new(editing, DraftPaths.Feature(index, FeatureDraft.NameKey), "Points.Name")
        {
            Row = () => NameOf(editing, index),
        };
        Flanks = [.. Enumerable.Range(0, editing.Draft.Features[index].Flanks.Count).Select(k => new FlankEdit(editing, index, k))];
        Remove = new(() => editing.Change("", d => d with { Features = d.Features.Without(index) }), () => editing.CanEdit);
        Up = new(
            () => editing.Change(
                "", d => d with { Features = d.Features.Replaced(index, d.Features[index - 1]).Replaced(index - 1, d.Features[index]) }),
            () => editing.CanEdit && index > 0);
    }

    public FeatureKind Kind { get; }

    public string KindName => Texts.Current["Kind." + Kind.Word];

    public string Icon => "Icon.kind-" + Kind.Word;

    public TextField Name { get; }

    /// <summary>Its points: one count, or one for each flank.</summary>
    public IReadOnlyList<FlankEdit> Flanks { get; }

    public Command Remove { get; }

    /// <summary>Moves it before the one above it in the order of cutting.</summary>
    public Command Up { get; }

    public string RemoveId => string.Create(CultureInfo.InvariantCulture, $"feature-{_index}-remove");

    public string UpId => string.Create(CultureInfo.InvariantCulture, $"feature-{_index}-up");

    public string RemoveName => Texts.Current.With("Points.Remove", Name.Text);

    public string UpName => Texts.Current.With("Points.Up", Name.Text);

    internal IEnumerable<EditField> Fields => [Name, .. Flanks.Select(f => f.Count)];

    /// <summary>Its name in the draft; empty if it no longer exists.</summary>
    internal static string NameOf(JobEditing editing, int index) =>
        index < editing.Draft.Features.Count ? editing.Draft.Features[index].Name : "";

    internal void Refresh()
    {
        Remove.Refresh();
        Up.Refresh();
        foreach (var flank in Flanks)
        {
            flank.Refresh();
        }

        if (_index < _editing.Draft.Features.Count)
        {
            OnPropertyChanged();
        }
    }
}
