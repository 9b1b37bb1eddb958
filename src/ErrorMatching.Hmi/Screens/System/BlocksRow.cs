namespace ErrorMatching.Hmi;

/// <summary>A feature with the blocks that cut it, typed or picked in the program.</summary>
/// <param name="index">Index of the feature, from 0.</param>
/// <param name="name">Its name.</param>
/// <param name="blocks">The field of its blocks.</param>
/// <param name="pick">Starts picking blocks for it.</param>
internal sealed class BlocksRow(int index, string name, TextField blocks, Command pick) : Observable
{
    private bool _isPicked;

    public int Index => index;

    public string Name => name;

    public TextField Blocks => blocks;

    public Command Pick => pick;

    public string PickId => "pick-" + Shown.Id(index);

    public bool IsPicked
    {
        get => _isPicked;
        internal set => Set(ref _isPicked, value);
    }
}
