namespace ErrorMatching.Hmi;

/// <summary>A feature with the blocks that cut it: typed, or picked in the program.</summary>
/// <param name="index">Which feature it is.</param>
/// <param name="name">Its name.</param>
/// <param name="blocks">The field of its blocks.</param>
/// <param name="pick">Picks blocks for it.</param>
public sealed class BlocksRow(int index, string name, TextField blocks, Command pick) : Observable
{
    private bool _isPicked;

    /// <summary>Which feature it is, from 0.</summary>
    public int Index => index;

    /// <summary>Its name.</summary>
    public string Name => name;

    /// <summary>The field of its blocks.</summary>
    public TextField Blocks => blocks;

    /// <summary>Picks blocks for it from now on.</summary>
    public Command Pick => pick;

    /// <summary>Identifies the button for that.</summary>
    public string PickId => "pick-" + Shown.Id(index);

    /// <summary>True while blocks are picked for it.</summary>
    public bool IsPicked
    {
        get => _isPicked;
        internal set => Set(ref _isPicked, value);
    }
}
