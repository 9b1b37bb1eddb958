using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A feature in the point set-up: its name, its kind and how many points it has.</summary>
public sealed class FeatureEdit : Observable
{
    private readonly JobEditing _editing;
    private readonly int _index;

    /// <summary>The feature of that number in the draft.</summary>
    public FeatureEdit(JobEditing editing, int index)
    {
        (_editing, _index) = (editing ?? throw new ArgumentNullException(nameof(editing)), index);
        Kind = editing.Draft.Features[index].Kind;
        Name = new(
            editing,
            DraftPaths.Feature(index, "name"),
            "Points.Name",
            d => d.Features[index].Name,
            (d, t) => d.WithFeature(index, f => f with { Name = t }))
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

    /// <summary>Its kind.</summary>
    public FeatureKind Kind { get; }

    /// <summary>Its kind in a word.</summary>
    public string KindName => Texts.Current["Kind." + Kind.Word];

    /// <summary>Key of the icon of its kind.</summary>
    public string Icon => "Icon.kind-" + Kind.Word;

    /// <summary>Its name.</summary>
    public TextField Name { get; }

    /// <summary>Its points: once, or for each flank.</summary>
    public IReadOnlyList<FlankEdit> Flanks { get; }

    /// <summary>Takes it away.</summary>
    public Command Remove { get; }

    /// <summary>Lets it be cut before the one above it.</summary>
    public Command Up { get; }

    /// <summary>Identifies the button that takes it away.</summary>
    public string RemoveId => string.Create(CultureInfo.InvariantCulture, $"feature-{_index}-remove");

    /// <summary>Identifies the button that moves it up.</summary>
    public string UpId => string.Create(CultureInfo.InvariantCulture, $"feature-{_index}-up");

    /// <summary>What the button does that takes it away.</summary>
    public string RemoveName => Texts.Current.With("Points.Remove", Name.Text);

    /// <summary>What the button does that moves it up.</summary>
    public string UpName => Texts.Current.With("Points.Up", Name.Text);

    /// <summary>Its fields.</summary>
    internal IEnumerable<EditField> Fields => [Name, .. Flanks.Select(f => f.Count)];

    /// <summary>Its name in the draft; empty for one that is not there any more.</summary>
    internal static string NameOf(JobEditing editing, int index) =>
        index < editing.Draft.Features.Count ? editing.Draft.Features[index].Name : "";

    /// <summary>Shows what the draft has.</summary>
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
            Say();
        }
    }
}
