using ErrorMatching.Jobs;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>A program as text and as a drawn path, to pick the blocks of each feature: what is chosen in one is lit in the other.</summary>
/// <remarks>
/// A screen makes one from an <see cref="OpenedProgram"/>, says which features there are (<see cref="MarkAsync"/>) and which one blocks are picked for (<see cref="Feature"/>), and listens to <see cref="RangeChosen"/>.
/// <c>Views</c> shows it wherever a screen puts it as content.
/// </remarks>
public sealed class ProgramPicture : Observable
{
    private BlockRange? _selection;
    private int? _anchor;
    private bool _isMoving;
    private bool _isNaming;
    private IReadOnlyList<FeatureMark> _marks = [];
    private IReadOnlyList<DraftPlace> _points = [];
    private string? _feature;
    private string? _message;
    private bool _isReadOnly;
    private bool _isWhole = true;

    /// <summary>The picture of a program.</summary>
    public ProgramPicture(OpenedProgram program)
    {
        Program = program ?? throw new ArgumentNullException(nameof(program));
        Take = new(() => Choose(isMore: false), () => CanChoose);
        Add = new(() => Choose(isMore: true), () => CanChoose && !IsFirst);
        Before = new(() => Move(-1, isExtending: false), () => Program.Count > 0);
        Behind = new(() => Move(1, isExtending: false), () => Program.Count > 0);
    }

    /// <summary>Said when a person has picked blocks for a feature.</summary>
    public event Action<RangeChoice>? RangeChosen;

    /// <summary>The program.</summary>
    public OpenedProgram Program { get; }

    /// <summary>The blocks that are lit; null if none are.</summary>
    public BlockRange? Selection
    {
        get => _selection;
        private set
        {
            if (Set(ref _selection, value))
            {
                Message = null;
                _isMoving = value is { } range && Program.IsMoving(range);
                SayChoice();
            }
        }
    }

    /// <summary>The block at the end that moves when the lit blocks become more or fewer: the one to be seen.</summary>
    public int Cursor { get; private set; }

    /// <summary>The features as they are marked.</summary>
    public IReadOnlyList<FeatureMark> Marks
    {
        get => _marks;
        private set
        {
            if (Set(ref _marks, value))
            {
                SayChoice();
            }
        }
    }

    /// <summary>Where the key points of the features lie in the program; none where that is not known.</summary>
    public IReadOnlyList<DraftPlace> Points
    {
        get => _points;
        set => Set(ref _points, value);
    }

    /// <summary>The feature that blocks are picked for; null if they are only looked at.</summary>
    public string? Feature
    {
        get => _feature;
        set
        {
            if (Set(ref _feature, value))
            {
                SayChoice();
            }
        }
    }

    /// <summary>The blocks of a feature that a person wants to see; null before anybody did. Said anew each time.</summary>
    public FeatureLook? Look { get; private set; }

    /// <summary>True where blocks cannot be picked, by somebody who may not.</summary>
    public bool IsReadOnly
    {
        get => _isReadOnly;
        set
        {
            if (Set(ref _isReadOnly, value))
            {
                SayChoice();
            }
        }
    }

    /// <summary>Takes the lit blocks for the feature, in place of those that it has.</summary>
    public Command Take { get; }

    /// <summary>Adds the lit blocks to those of the feature.</summary>
    public Command Add { get; }

    /// <summary>Lights the block before.</summary>
    public Command Before { get; }

    /// <summary>Lights the block behind.</summary>
    public Command Behind { get; }

    /// <summary>The naming of blocks that is under way, or the last one.</summary>
    public Task Choosing { get; private set; } = Task.CompletedTask;

    /// <summary>Why blocks could not be taken, or what is wrong with the program; null if nothing is to be said.</summary>
    public string? Message
    {
        get => _message ?? Program.Problem;
        private set => Set(ref _message, value);
    }

    /// <summary>The lit blocks in words.</summary>
    public string Chosen => Selection is not { } range ? Look is { } look && look.Feature == Feature ? Texts.Current.With(_isWhole ? "Program.Looked" : look.IsAtEnd ? "Program.LookedEnd" : "Program.LookedBegin", look.Feature, NameOf(look.Blocks)) : Texts.Current["Program.NothingChosen"]
        : IsPicking && !_isMoving ? Texts.Current.With("Program.MovesNothing", NameOf(range)) : NameOf(range);

    /// <summary>The text of the lit block, of several the one that was lit last, whole; empty if none is lit. Beside the others it may be cut.</summary>
    public string ChosenLine => Selection is null ? "" : Program.LineAt(Cursor);

    /// <summary>What <see cref="Take"/> does, in words.</summary>
    public string TakeText => Feature is null ? Texts.Current["Program.Take"] : Texts.Current.With(IsFirst ? "Program.TakeFor" : "Program.ReplaceFor", Feature);

    /// <summary>True where <see cref="Take"/> replaces nothing.</summary>
    public bool IsFirst => !Marks.Any(m => m.Name == Feature && m.Ranges.Count > 0);

    /// <summary>True if blocks are picked for a feature at all.</summary>
    public bool IsPicking => Feature is not null && !IsReadOnly;

    // What moves nothing cuts no feature. What is being named is taken already: a second tap would take it for the next feature.
    private bool CanChoose => IsPicking && _isMoving && !_isNaming;

    /// <summary>Marks features by their blocks as the job names them. They are looked for beside the screen.</summary>
    public async Task MarkAsync(IReadOnlyList<FeatureBlocks> features)
    {
        var program = Program.Path.Program;
        Marks = await Task.Run(() => features.Select(f => Mark(program, f)).ToArray());
    }

    /// <summary>Lights a block.</summary>
    public void Light(int block)
    {
        if (Program.Count > 0)
        {
            _anchor = Math.Clamp(block, 0, Program.Count - 1);
            Extend(_anchor.Value);
        }
    }

    /// <summary>Lights all blocks from the one that was lit first to another one.</summary>
    public void Extend(int block)
    {
        if (Program.Count > 0)
        {
            Cursor = Math.Clamp(block, 0, Program.Count - 1);
            Selection = BlockRange.Between(_anchor ??= Cursor, Cursor);
            Say(nameof(ChosenLine));
        }
    }

    /// <summary>Lights the block so many lines further, or all up to there.</summary>
    public void Move(int lines, bool isExtending)
    {
        // Where nothing is lit any more, it goes on from what was.
        var to = _anchor is null ? 0 : Cursor + lines;
        if (isExtending && Selection is not null)
        {
            Extend(to);
        }
        else
        {
            Light(to);
        }
    }

    /// <summary>Lights nothing any more.</summary>
    public void Unlight() => Selection = null;

    /// <summary>Shows all blocks of a feature, from the first to the last; where they are more than have room, and are shown from the beginning already, their end.</summary>
    /// <param name="feature">Its name.</param>
    public void LookAt(string feature)
    {
        if (Marks.FirstOrDefault(m => m.Name == feature) is { Ranges: [var first, ..] ranges })
        {
            var blocks = new BlockRange(first.First, ranges.Max(r => r.Last));
            Look = new(feature, blocks, IsAtEnd: Look is { IsAtEnd: false } was && was.Feature == feature && was.Blocks == blocks);
            _isWhole = true;
            Say(nameof(Look));
            Say(nameof(Chosen));
        }
    }

    /// <summary>Says whether all of what a person wants to see has room.</summary>
    internal void TellRoom(bool isWhole)
    {
        _isWhole = isWhole;
        Say(nameof(Chosen));
    }

    /// <summary>Lights the block of a motion.</summary>
    public void LightMotion(int motion) => Light(Program.Path.Motions.BlockOf(motion));

    /// <summary>The name of the feature that a block belongs to; null if it belongs to none.</summary>
    public string? FeatureOf(int block) => Marks.FirstOrDefault(m => m.Ranges.Any(r => r.Contains(block)))?.Name;

    /// <summary>Says all texts anew, in another language.</summary>
    public void Translate() => Say();

    private static FeatureMark Mark(NcProgram program, FeatureBlocks feature)
    {
        try
        {
            var selected = BlockSelector.Select(program, [.. feature.Blocks.Select(BlockSelector.Parse)]);
            return selected.IsUsable ? new(feature.Name, BlockRange.Of(selected.Value), null) : new(feature.Name, [], CodeText.Of(selected.Refusal.Code, selected.Refusal.Message));
        }
        catch (NcException e)
        {
            return new(feature.Name, [], CodeText.Of(ErrorItems.Of(e).Code, e.Message));
        }
    }

    private void Choose(bool isMore) => Choosing = ChooseAsync(Feature!, Selection!.Value, isMore).Watched();

    private async Task ChooseAsync(string feature, BlockRange range, bool isMore)
    {
        var program = Program;
        Name(true);
        try
        {
            var words = await Task.Run(() =>
            {
                var (first, last) = program.Trimmed(range);
                return BlockNames.Of(program.Path.Program, first, last);
            });
            if (!words.IsUsable)
            {
                Message = CodeText.Of(words.Refusal.Code, words.Refusal.Message);
                return;
            }

            // What is taken is lit no more: the next feature takes other blocks.
            Selection = Selection == range ? null : Selection;
            Message = null;
            RangeChosen?.Invoke(new(feature, words.Value, isMore));
        }
        finally
        {
            Name(false);
        }
    }

    private void Name(bool isNaming)
    {
        _isNaming = isNaming;
        SayChoice();
    }

    private string NameOf(BlockRange range) => range.Count == 1
        ? Program.NameOf(range.First)
        : Texts.Current.With("Program.Range", Program.NameOf(range.First), Program.NameOf(range.Last), Shown.Count(range.Count));

    private void SayChoice()
    {
        Say(nameof(Chosen));
        Say(nameof(ChosenLine));
        Say(nameof(TakeText));
        Say(nameof(IsFirst));
        Say(nameof(IsPicking));
        foreach (var command in new[] { Take, Add })
        {
            command.Refresh();
        }
    }
}
