using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>A kind of feature that can be added.</summary>
/// <param name="kind">The kind.</param>
/// <param name="add">Adds a feature of it.</param>
public sealed class KindChoice(FeatureKind kind, Command add) : Observable
{
    /// <summary>Adds a feature of it.</summary>
    public Command Add { get; } = add;

    /// <summary>What its button says.</summary>
    public string Name => Texts.Current["Points.Add." + kind];

    /// <summary>Key of its icon.</summary>
    public string Icon => "Icon.kind-" + kind;

    /// <summary>Identifies its button.</summary>
    public string Id => "add-" + kind;

    /// <summary>Shows whether it can be added, in the language of the station.</summary>
    internal void Refresh()
    {
        Add.Refresh();
        Say(nameof(Name));
    }
}
