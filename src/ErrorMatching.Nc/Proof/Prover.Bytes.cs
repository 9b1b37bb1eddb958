namespace ErrorMatching.Nc;

/// <content>Every byte outside the values of words that had to change must be the original's.</content>
public sealed partial class Prover
{
    /// <summary>Blocks that are compared in one go where many differ: whoever has nothing else to do takes the next.</summary>
    private const int PartOfMany = 16_384;

    private List<Task<(bool Identical, List<NcRefusal> Failures)>> CompareBytes(int markerBlock)
    {
        var blocks = _before.Program.BlockCount;
        var border = markerBlock < 0 ? blocks : markerBlock;
        return [.. CompareBytes(0, border, 0), .. CompareBytes(border, blocks, 1)];
    }

    private IEnumerable<Task<(bool Identical, List<NcRefusal> Failures)>> CompareBytes(int from, int end, int linesBefore)
    {
        var many = _different.Count >= Many;
        for (var first = from; first < end;)
        {
            var (begin, behind) = (first, many ? Math.Min(end, first + PartOfMany) : end);
            yield return many ? Task.Run(() => ComparePart(begin, behind, linesBefore)) : Task.FromResult(ComparePart(begin, behind, linesBefore));
            first = behind;
        }
    }

    // Blocks of the original that stand a number of lines further down in the result.
    private (bool Identical, List<NcRefusal> Failures) ComparePart(int first, int behind, int linesBefore)
    {
        var compared = new BlockComparison(_before, _after);
        var failures = new List<NcRefusal>();
        var (identical, recent) = (true, 0);
        for (var i = compared.NextDifference(first, behind, linesBefore); i < behind; i = compared.NextDifference(i + 1, behind, linesBefore))
        {
            var motion = _before.RunOf(i, 0, ref recent);
            if (motion < 0 || !compared.SameButCoordinates(motion, i, i + linesBefore))
            {
                failures.Add(Failure(i, "something other than the words of its new place changed in it."));
                identical = false;
            }
            else if (!Moved(i, ref recent))
            {
                failures.Add(Failure(i, "its words changed although its motion, as far as the program says where it is, did not."));
                identical = false;
            }
            else if (Obstacles.Of(_before, motion) is { } obstacle)
            {
                failures.Add(Failure(i, $"it changed although {obstacle.Message}"));
            }
        }

        return (identical, failures);
    }

    private bool Moved(int block, ref int recent)
    {
        for (var run = 0; _before.RunOf(block, run, ref recent) is >= 0 and var i; run++)
        {
            var (was, now) = (_before.Motions[i], _after.Motions[i]);
            if (was.Start != now.Start || was.End != now.End || was.Center != now.Center)
            {
                return true;
            }
        }

        return false;
    }
}
