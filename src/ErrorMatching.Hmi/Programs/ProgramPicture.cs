using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>A program as text and as a drawn path, to pick the blocks of each feature. A selection in one shows in the other.</summary>
/// <remarks>A screen creates one from an <see cref="OpenedProgram"/>, sets the features (<see cref="MarkAsync"/>) and the one
/// that blocks are picked for (<see cref="Feature"/>), and listens to <see cref="RangeChosen"/>. <c>Views</c> supplies its view
/// if a screen uses it as content.</remarks>
public sealed class ProgramPicture : Observable
{
    private BlockRange? _selection;
    private int? _anchor;
    private bool _isMoving;
    private bool _isNaming;
    private IReadOnlyList<FeatureMark> _marks = [];
    private IReadOnlyList<DraftPlace> _points = [];
    private IReadOnlyList<IReadOnlyList<Point2>> _outline = [];
    private string? _feature;
    private bool _isReadOnly;
    private bool _isWhole = true;

    /// <summary>Creates the picture of a program.</summary>
    public ProgramPicture(OpenedProgram program)
    {
        Program = program ?? throw new ArgumentNullException(nameof(program));
        Take = new(() => Choose(isMore: false), () => CanChoose);
        Add = new(() => Choose(isMore: true), () => CanChoose && !IsFirst);
        Before = new(() => Move(-1, isExtending: false), () => Program.Count > 0);
        Behind = new(() => Move(1, isExtending: false), () => Program.Count > 0);
    }

    /// <summary>Raised when the user has picked blocks for a feature.</summary>
    public event Action<RangeChoice>? RangeChosen;

    public OpenedProgram Program { get; }

    /// <summary>The selected blocks; null if none are.</summary>
    public BlockRange? Selection
    {
        get => _selection;
        private set
        {
            if (Set(ref _selection, value))
            {
                _isMoving = value is { } range && Program.IsMoving(range);
                OnChoiceChanged();
            }
        }
    }

    /// <summary>The end of the selection that moves when it is extended; this block is kept in view.</summary>
    public int Cursor { get; private set; }

    /// <summary>The marked features.</summary>
    public IReadOnlyList<FeatureMark> Marks
    {
        get => _marks;
        private set
        {
            if (Set(ref _marks, value))
            {
                OnChoiceChanged();
            }
        }
    }

    /// <summary>Positions of the features' key points in the program; empty if unknown.</summary>
    public IReadOnlyList<DraftPlace> Points
    {
        get => _points;
        set => Set(ref _points, value);
    }

    /// <summary>Lines over the path: the outline of a drawing, in the frame of the program; empty for none.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Outline
    {
        get => _outline;
        set => Set(ref _outline, value);
    }

    /// <summary>The feature that blocks are picked for; null if the program is only viewed.</summary>
    public string? Feature
    {
        get => _feature;
        set
        {
            if (Set(ref _feature, value))
            {
                OnChoiceChanged();
            }
        }
    }

    /// <summary>The last request to show the blocks of a feature; null if there was none. Equal requests are reported, too.</summary>
    public FeatureLook? Look { get; private set; }

    /// <summary>True if the user may not pick blocks.</summary>
    public bool IsReadOnly
    {
        get => _isReadOnly;
        set
        {
            if (Set(ref _isReadOnly, value))
            {
                OnChoiceChanged();
            }
        }
    }

    /// <summary>Assigns the selected blocks to the feature and replaces its blocks.</summary>
    public Command Take { get; }

    /// <summary>Adds the selected blocks to the feature.</summary>
    public Command Add { get; }

    /// <summary>Selects the previous block.</summary>
    public Command Before { get; }

    /// <summary>Selects the next block.</summary>
    public Command Behind { get; }

    /// <summary>The current search for the selectors of picked blocks, or the last one.</summary>
    public Task Choosing { get; private set; } = Task.CompletedTask;

    /// <summary>What is wrong with the program; null if nothing is.</summary>
    public string? Message => Program.Problem;

    /// <summary>The selection in words.</summary>
    public string Chosen =>
        Selection is not { } range
            ? Look is { } look && look.Feature == Feature
            ? Texts.Current.With(
                _isWhole ? "Program.Looked" : look.IsAtEnd ? "Program.LookedEnd" : "Program.LookedBegin", look.Feature, NameOf(look.Blocks))
            : Texts.Current["Program.NothingChosen"]
        : IsPicking && !_isMoving ? Texts.Current.With("Program.MovesNothing", NameOf(range)) : NameOf(range);

    /// <summary>The whole text of the block selected last, which may be cut off in the list; empty if none is selected.</summary>
    public string ChosenLine => Selection is null ? "" : Program.LineAt(Cursor);

    /// <summary>The label of <see cref="Take"/>.</summary>
    public string TakeText =>
        Feature is null ? Texts.Current["Program.Take"] : Texts.Current.With(IsFirst ? "Program.TakeFor" : "Program.ReplaceFor", Feature);

    /// <summary>True if <see cref="Take"/> replaces nothing.</summary>
    public bool IsFirst => !Marks.Any(m => m.Name == Feature && m.Ranges.Count > 0);

    /// <summary>True if blocks are being picked for a feature.</summary>
    public bool IsPicking => Feature is not null && !IsReadOnly;

    // Blocks that move nothing cut no feature. While a choice is being processed, a second tap would assign it to the next feature.
    private bool CanChoose => IsPicking && _isMoving && !_isNaming;

    /// <summary>Marks features by the selectors of the job. The blocks are searched for in the background.</summary>
    public async Task MarkAsync(IReadOnlyList<FeatureBlocks> features)
    {
        var program = Program.Path.Program;
        Marks = await Task.Run(() => features.Select(f => Mark(program, f)).ToArray());
    }

    /// <summary>Selects a block.</summary>
    public void Light(int block)
    {
        if (Program.Count > 0)
        {
            _anchor = Math.Clamp(block, 0, Program.Count - 1);
            Extend(_anchor.Value);
        }
    }

    /// <summary>Extends the selection from its first block to another one.</summary>
    public void Extend(int block)
    {
        if (Program.Count > 0)
        {
            Cursor = Math.Clamp(block, 0, Program.Count - 1);
            Selection = BlockRange.Between(_anchor ??= Cursor, Cursor);
            OnPropertyChanged(nameof(ChosenLine));
        }
    }

    /// <summary>Moves the selection by a number of lines, or extends it.</summary>
    public void Move(int lines, bool isExtending)
    {
        // Continues from the last block even if nothing is selected now.
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

    /// <summary>Clears the selection.</summary>
    public void Unlight() => Selection = null;

    /// <summary>Shows all blocks of a feature, from the first to the last. If they do not fit and their beginning is already
    /// shown, shows their end.</summary>
    /// <param name="feature">Its name.</param>
    public void LookAt(string feature)
    {
        if (Marks.FirstOrDefault(m => m.Name == feature) is { Ranges: [var first, ..] ranges })
        {
            var blocks = new BlockRange(first.First, ranges.Max(r => r.Last));
            Look = new(feature, blocks, IsAtEnd: Look is { IsAtEnd: false } was && was.Feature == feature && was.Blocks == blocks);
            _isWhole = true;
            OnPropertyChanged(nameof(Look));
            OnPropertyChanged(nameof(Chosen));
        }
    }

    /// <summary>Sets whether all the requested blocks fit.</summary>
    internal void TellRoom(bool isWhole)
    {
        _isWhole = isWhole;
        OnPropertyChanged(nameof(Chosen));
    }

    /// <summary>Selects the block of a motion.</summary>
    public void LightMotion(int motion) => Light(Program.Path.Motions.BlockOf(motion));

    /// <summary>The name of the feature that a block belongs to; null if there is none.</summary>
    public string? FeatureOf(int block) => Marks.FirstOrDefault(m => m.Ranges.Any(r => r.Contains(block)))?.Name;

    /// <summary>Updates all texts after a change of language.</summary>
    public void Translate() => OnPropertyChanged();

    private static FeatureMark Mark(NcProgram program, FeatureBlocks feature)
    {
        try
        {
            var selected = BlockSelector.Select(program, [.. feature.Blocks.Select(BlockSelector.Parse)]);
            return selected.IsUsable
                ? new(feature.Name, BlockRange.Of(selected.Result), null)
                : new(feature.Name, [], CodeText.Of(selected.Refusal.Code, selected.Refusal.Message));
        }
        catch (InputException e)
        {
            return new(feature.Name, [], CodeText.Of(e.Code, e.Message));
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

            // Clears the selection after use: the next feature needs other blocks.
            Selection = Selection == range ? null : Selection;
            RangeChosen?.Invoke(new(feature, words, isMore));
        }
        finally
        {
            Name(false);
        }
    }

    private void Name(bool isNaming)
    {
        _isNaming = isNaming;
        OnChoiceChanged();
    }

    private string NameOf(BlockRange range) => range.Count == 1
        ? Program.NameOf(range.First)
        : Texts.Current.With("Program.Range", Program.NameOf(range.First), Program.NameOf(range.Last), Shown.Count(range.Count));

    private void OnChoiceChanged()
    {
        OnPropertyChanged(nameof(Chosen));
        OnPropertyChanged(nameof(ChosenLine));
        OnPropertyChanged(nameof(TakeText));
        OnPropertyChanged(nameof(IsFirst));
        OnPropertyChanged(nameof(IsPicking));
        foreach (var command in new[] { Take, Add })
        {
            command.Refresh();
        }
    }
}

/// <summary>A feature of a job with the selectors of its blocks.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors as written in the job: <c>N120</c>, <c>N130..N160</c>, <c>/expression/</c>.</param>
public sealed record FeatureBlocks(string Name, IReadOnlyList<string> Blocks);

/// <summary>A request to show the blocks of a feature.</summary>
/// <param name="Feature">Its name.</param>
/// <param name="Blocks">From its first block to its last.</param>
/// <param name="IsAtEnd">If they do not all fit: true to show the end, false to show the beginning.</param>
public sealed record FeatureLook(string Feature, BlockRange Blocks, bool IsAtEnd);

/// <summary>The marking of a feature in a program: its name next to its blocks and moves, and a bar; not color alone.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Ranges">Its blocks.</param>
/// <param name="Problem">Why some of its blocks were not found; null if all were found.</param>
public sealed record FeatureMark(string Name, IReadOnlyList<BlockRange> Ranges, string? Problem);

/// <summary>Blocks that the user picked for a feature.</summary>
/// <param name="Feature">The feature's name.</param>
/// <param name="Blocks">The blocks as selectors of a job: <c>N120</c>, <c>N130..N160</c>.</param>
/// <param name="IsMore">True to add them to the feature's blocks, false to replace those.</param>
public sealed record RangeChoice(string Feature, IReadOnlyList<string> Blocks, bool IsMore);
