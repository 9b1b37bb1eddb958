namespace ErrorMatching.Nc;

/// <content>Every byte outside the values of words that had to change must be the original's.</content>
public sealed partial class Prover
{
    private (bool Identical, List<NcRefusal> Failures) CompareBytes(int markerBlock)
    {
        var blocks = _before.Program.BlockCount;
        var compared = new BlockComparison(_before, _after);
        var failures = new List<NcRefusal>();
        var border = markerBlock < 0 ? blocks : markerBlock;
        var identical = CompareBytes(compared, 0, border, 0, failures) & CompareBytes(compared, border, blocks, 1, failures);
        return (identical, failures);
    }

    // Blocks of the original that stand a number of lines further down in the result.
    private bool CompareBytes(BlockComparison compared, int first, int behind, int linesBefore, List<NcRefusal> failures)
    {
        var identical = true;
        for (var i = compared.NextDifference(first, behind, linesBefore); i < behind; i = compared.NextDifference(i + 1, behind, linesBefore))
        {
            var motion = _before.MotionOf(i);
            if (motion < 0 || !compared.SameButCoordinates(motion, i, i + linesBefore))
            {
                failures.Add(Failure(i, "something other than the words of its new place changed in it."));
                identical = false;
            }
            else if (!Moved(i))
            {
                failures.Add(Failure(i, "its words changed although its motion, as far as the program says where it is, did not."));
                identical = false;
            }
            else if (Obstacles.Of(_before, motion) is { } obstacle)
            {
                failures.Add(Failure(i, $"it changed although {obstacle.Message}"));
            }
        }

        return identical;
    }

    private bool Moved(int block)
    {
        foreach (var i in _before.MotionsOf(block))
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
