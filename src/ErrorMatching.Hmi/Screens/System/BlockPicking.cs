using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>The program as text and path, in which the blocks of the features are picked or found.</summary>
internal sealed class BlockPicking
{
    private readonly JobEditing _editing;
    private readonly Action _shown;
    private PictureOf? _of;
    private ProgramPicture? _picture;
    private Task _marking = Task.CompletedTask;
    private string _marked = "";
    private int _picked;

    /// <summary>Shows no program yet.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="shown">Called on the UI thread when there is another <see cref="Picture"/>.</param>
    public BlockPicking(JobEditing editing, Action shown)
    {
        (_editing, _shown) = (editing, shown);
        FindBlocks = new(
            FindBlocksAsync, () => editing.CanEdit && Picture is not null && editing.Draft.Features.Any(f => f.BlockList.Count == 0));
    }

    /// <summary>The program; null while there is none, or while it is being opened.</summary>
    public ProgramPicture? Picture
    {
        get => _picture;
        private set
        {
            if (_picture != value)
            {
                _picture = value;
                _shown();
            }
        }
    }

    /// <summary>The features with their blocks.</summary>
    public IReadOnlyList<BlocksRow> Rows { get; private set; } = [];

    /// <summary>Finds the blocks of features without blocks by their key points.</summary>
    public LongCommand FindBlocks { get; }

    /// <summary>Completes when the program is open and its features are marked.</summary>
    public Task Opening { get; private set; } = Task.CompletedTask;

    /// <summary>Recreates the rows; picking starts with the first feature without blocks.</summary>
    public void MakeRows(IEnumerable<TextField> blocks)
    {
        _picked = NextPicked(0);
        Rows = [.. blocks.Select((b, i) => new BlocksRow(i, _editing.Draft.Features[i].Name, b, new(() => PickFor(i))))];
    }

    /// <summary>Does something that recreates the rows; picking blocks for a feature continues.</summary>
    public void Continue(Action recreate)
    {
        var picked = _picked;
        recreate();
        _picked = picked;
        Show();
    }

    /// <summary>Shows the draft's program with its features.</summary>
    public void Show()
    {
        var draft = _editing.Draft;
        var of = new PictureOf(
            _editing.Job?.File, draft[DraftPaths.Program], draft.Program, draft[DraftPaths.Dialect], draft[DraftPaths.BlockSkip]);
        if (of != _of)
        {
            (_of, Picture) = (of, null);
            Opening = OpenAsync(of, draft).Watched();
        }

        foreach (var row in Rows)
        {
            row.IsPicked = row.Index == _picked && Picture is not null;
        }

        if (Picture is { } picture)
        {
            picture.IsReadOnly = !_editing.CanEdit;
            FindBlocks.Refresh();
            picture.Feature = _picked < draft.Features.Count ? draft.Features[_picked].Name : null;
            Mark(picture, draft);
        }
    }

    // Picking continues with the next feature without blocks.
    private int NextPicked(int otherwise) =>
        _editing.Draft.Features.Select((f, i) => (f, i)).FirstOrDefault(f => string.IsNullOrWhiteSpace(f.f.Blocks), (null!, otherwise)).i;

    private void PickFor(int feature)
    {
        _picked = feature;
        Show();
        Picture?.LookAt(_editing.Draft.Features[feature].Name);
    }

    private async Task OpenAsync(PictureOf of, MatingDraft draft)
    {
        if (await Task.Run(() => Open(of, draft)) is { } opened && of == _of)
        {
            _marked = "";
            var picture = new ProgramPicture(opened);
            picture.RangeChosen += choice => TakeBlocks(picture, choice);
            Picture = picture;
            Show();
            await _marking;
        }
    }

    private static OpenedProgram? Open(PictureOf of, MatingDraft draft)
    {
        try
        {
            return of.Job is null || of.Program.Length == 0
                ? null
                : OpenedProgram.Read(MatingDraftCheck.ProgramOf(draft, of.Job), MatingDraftCheck.DialectOf(draft, of.Job));
        }
        catch (Exception e) when (e is InputException or ArgumentException)
        {
            // Problems with the program or its control are shown at their fields.
            return null;
        }
    }

    // Mark drafts one after the other, so that the last marks are those of the last draft.
    private void Mark(ProgramPicture picture, MatingDraft draft)
    {
        var marked = string.Join(
            '\n',
            draft.Features.Select(f => $"{f.Name}: {f.Blocks}; {f.Plane} {string.Join(' ', f.Points)}")
                .Append(draft[DraftPaths.Counterpart]));
        if (marked != _marked)
        {
            _marked = marked;

            // Do not take blocks that a feature got in another way for the next one.
            picture.Unlight();
            _marking = MarkAsync(_marking, picture, draft).Watched();
        }
    }

    private static async Task MarkAsync(Task before, ProgramPicture picture, MatingDraft draft)
    {
        await before;
        await picture.MarkAsync([.. draft.Features.Where(f => f.Blocks.Length > 0).Select(f => new FeatureBlocks(f.Name, f.BlockList))]);
        var plane = picture.Program.Moves.Plane;
        picture.Points = await Task.Run(() => MatingDraftPlaces.Find(draft).Where(p => p.Plane == plane).ToArray());
    }

    // Another program may have been opened since the blocks were chosen.
    private void TakeBlocks(ProgramPicture picture, RangeChoice choice)
    {
        var feature = _picked;
        if (picture == Picture && _editing.CanEdit && feature < _editing.Draft.Features.Count)
        {
            _editing.Change("", d => MatingDraftBlocks.WithBlocks(
                d, [(feature, choice.Blocks)], picture.Program.Path.Program, choice.IsMore));
            _picked = choice.IsMore ? feature : NextPicked(feature);
            Show();
        }
    }

    // A proposal: the user checks it, and can undo it in one step.
    private async Task FindBlocksAsync(CancellationToken end)
    {
        MatingDraft draft;
        NcPath path;
        IReadOnlyList<ProposedBlocks> proposed;
        do
        {
            if (Picture is not { } picture)
            {
                return;
            }

            (draft, path) = (_editing.Draft, picture.Program.Path);
            proposed = await Task.Run(() => MatingDraftBlocks.Propose(draft, path), end);
        }
        while (!ReferenceEquals(draft, _editing.Draft) || !ReferenceEquals(path, Picture?.Program.Path));

        var found = proposed.Where(p => p.Blocks.Count > 0).ToArray();
        _editing.Change(
            "", d => MatingDraftBlocks.WithBlocks(d, [.. found.Select(p => (p.Feature, p.Blocks))], path.Program));
        _picked = NextPicked(_picked);
        Show();
        string[] missed = [.. proposed.Where(p => p.Blocks.Count == 0).Select(p => p.Name)];
        _editing.Note(() => Sentence.Joined(
            found.Length > 0 ? Texts.Current.With("System.BlocksFound", Texts.Current.Listed(found.Select(p => p.Name))) : "",
            missed.Length > 0 ? Texts.Current.With("System.BlocksMissed", Texts.Current.Listed(missed)) : ""));
    }

    /// <summary>What a picture depends on; while it is unchanged, the picture stays.</summary>
    private sealed record PictureOf(string? Job, string Program, DraftProgram? Imported, string Dialect, string BlockSkip);
}
