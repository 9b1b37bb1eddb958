using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A kind of feature that can be added.</summary>
/// <param name="kind">The kind.</param>
/// <param name="add">Adds a feature of it.</param>
internal sealed class KindChoice(FeatureKind kind, Command add) : Observable
{
    public Command Add { get; } = add;

    public string Name => Texts.Current["Points.Add." + kind];

    public string Icon => "Icon.kind-" + kind;

    public string Id => "add-" + kind;

    /// <summary>Updates its availability and its text in the display language.</summary>
    internal void Refresh()
    {
        Add.Refresh();
        OnPropertyChanged(nameof(Name));
    }
}
