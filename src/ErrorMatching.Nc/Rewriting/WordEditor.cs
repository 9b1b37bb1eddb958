using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Turns new joints and centers into the fewest changed words.</summary>
internal sealed class WordEditor
{
    /// <summary>Minimum number of blocks for a second thread to pay off.</summary>
    private const int Many = 10_000;

    /// <summary>Number of blocks that are sampled for the spelling of all.</summary>
    private const int First = 100;

    private readonly NcPath _path;
    private readonly List<int> _affected;
    private readonly BlockPatches _patches;
    private readonly IncrementGrid _grid;
    private readonly bool _programIsFixed;
    private readonly MotionWords _words;

    private WordEditor(PathChange change, int spelledLike)
    {
        (_path, _affected) = (change.Path, change.Affected());

        // Reserve room for both halves now, so that the list is not copied later.
        _patches = new(_affected.Count);

        // The control's least increment, or a finer one if the program itself is finer.
        var dialect = _path.Dialect;
        var isInch = _path.Motions[_affected.Find(i => change.IsSet(i + 1))].Has(MotionFlags.Inch);
        var least = isInch ? dialect.InchDecimals : dialect.MetricDecimals;
        (var decimals, _programIsFixed) = IncrementGrid.Spelling(_path, _affected, spelledLike, least);
        _grid = new(change, isInch, decimals);
        _words = new(change, _grid, new(_path.Program, _programIsFixed, dialect.IntegersAreIncrements ? least : -1));
    }

    /// <summary>Rewrites the words of a change.</summary>
    /// <param name="change">New joints and centers.</param>
    public static Outcome<Rewrite> Run(PathChange change)
    {
        var affected = change.Affected();
        if (affected.Count == 0)
        {
            return Rewrite.None(change.Path);
        }

        // Many blocks are mostly spelled like the first of them. Then there is no need to read them all beforehand.
        return affected.Count >= Many
            && new WordEditor(change, spelledLike: First).RunIfSpelledAlike() is { } rewrite
            ? rewrite
            : new WordEditor(change, affected.Count).Run();
    }

    // Null if a block does not match the sampled style or cannot be edited.
    private Rewrite? RunIfSpelledAlike()
    {
        if (BlocksRepeat() || EditMany() is not null || _words.EditPoles(_patches) is not null)
        {
            return null;
        }

        var (decimals, isFixed) = _words.Spelling;
        return decimals <= _grid.Decimals && isFixed == _programIsFixed ? Result() : null;
    }

    private Outcome<Rewrite> Run()
    {
        var refusal = BlocksRepeat()
            ? new RepeatedBlocks(_path, _words).Edit(_affected, _patches)
            : _affected.Count < Many
            ? Edit(_affected, _words, _patches)
            : EditMany();
        refusal ??= _words.EditPoles(_patches);
        return refusal is null ? Result() : refusal;
    }

    private Rewrite Result()
    {
        var (patches, program) = (_patches.All, _path.Program);
        var rewritten = patches.Count == 0 ? program : NcProgram.Read(NcPatch.Apply(program.Bytes, patches), program.Syntax);
        return new Rewrite(rewritten, patches, _patches.Blocks, patches.Count, _grid.Increment);
    }

    // A loop around a single motion is in block order, but runs one block several times.
    private bool BlocksRepeat()
    {
        if (!_path.Motions.FollowBlocks)
        {
            return true;
        }

        foreach (var motion in _affected)
        {
            var block = _path.Motions.BlockOf(motion);
            if ((motion > 0 && _path.Motions.BlockOf(motion - 1) == block)
                || (motion + 1 < _path.Motions.Length && _path.Motions.BlockOf(motion + 1) == block))
            {
                return true;
            }
        }

        return false;
    }

    // Each block is edited independently, so two concurrent halves give the same result as a sequential run.
    private Refusal? EditMany()
    {
        var half = _affected.Count / 2;
        while (half > 0 && _path.Motions.BlockOf(_affected[half - 1]) == _path.Motions.BlockOf(_affected[half]))
        {
            half--;
        }

        var (others, later) = (_words.ForOthers(), new BlockPatches(_affected.Count / 2));
        var behind = Task.Run(() => Edit(_affected[half..], others, later));
        var refusal = Edit(_affected[..half], _words, _patches);
        refusal ??= behind.GetAwaiter().GetResult();
        _patches.Join(later);
        _words.Join(others);
        return refusal;
    }

    private Refusal? Edit(List<int> motions, MotionWords words, BlockPatches patches)
    {
        foreach (var motion in motions)
        {
            if (words.Edit(motion) is { } refusal)
            {
                return refusal;
            }

            patches.Add(_path.Motions.BlockOf(motion), words.Patches);
        }

        return null;
    }
}
