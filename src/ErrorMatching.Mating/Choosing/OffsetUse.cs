using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Which offsets of the control the features of a program are cut with, and why one cannot be changed.</summary>
internal sealed class OffsetUse
{
    private readonly JobCorrection _correction;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;

    /// <summary>Looks for the offsets.</summary>
    public OffsetUse(JobCorrection correction, NcPath path, IReadOnlyList<FeatureMap> maps)
    {
        (_correction, _path, _maps) = (correction, path, maps);
        // A setter of a machine in inches reads its offsets in inches, and so must the program that changes them.
        var isInInches = Own().Any(i => path.Motions[i].Has(MotionFlags.Inch));
        var inches = isInInches ? "the program is in inches, and offsets are written in mm" : null;
        (NotByRadius, NotByWorkOffset, NotByTurn) = (inches ?? RadiusReason(), inches ?? WorkReason(), Turns());
    }

    /// <summary>Number of the radius offset; null if there is none that could be changed, whatever else moves with it.</summary>
    public int? RadiusNumber { get; private set; }

    /// <summary>Number of the work offset; null in the same case.</summary>
    public int? WorkOffsetNumber { get; private set; }

    /// <summary>Why the radius of the tool cannot be changed; null if it can.</summary>
    public string? NotByRadius { get; }

    /// <summary>Why the work offset cannot be changed; null if it can.</summary>
    public string? NotByWorkOffset { get; }

    /// <summary>Why the work offset cannot be rotated; null if it can.</summary>
    public string? NotByTurn { get; }

    private string? RadiusReason()
    {
        if (!OffsetProgram.CanChangeRadius(_path.Dialect))
        {
            return $"the dialect {_path.Dialect.Name} does not say how a radius offset is changed";
        }

        var numbers = OffsetsInUse.RadiusNumbers(_path);
        var own = Own().Select(i => numbers[i]).Distinct().ToArray();
        if (own.Contains(null))
        {
            return "the features are cut without cutter compensation, so the tool's radius moves nothing";
        }

        if (own.Length > 1)
        {
            return "the features are cut with several radius offsets";
        }

        var named = own[0] is { } n && n == Math.Floor(n) && n is > 0 and < int.MaxValue ? (int)n : (int?)null;
        if ((named ?? _correction.RadiusOffset) is not { } number)
        {
            return "the program does not name the radius offset by D; state \"radiusOffset\"";
        }

        if (OffsetProgram.NeedsTool(_path.Dialect) && _correction.Tool is null)
        {
            return "the control keeps offsets by tool; state \"tool\"";
        }

        RadiusNumber = number;
        return _correction.OtherCutsMayMove ? null : Other(i => numbers[i] is { } x && (x.Equals(own[0]) || double.IsNaN(x)));
    }

    private string? WorkReason()
    {
        if (!OffsetProgram.CanShift(_path.Dialect))
        {
            return $"the dialect {_path.Dialect.Name} does not say how a work offset is changed";
        }

        var numbers = OffsetsInUse.WorkOffsets(_path);
        var own = Own().Select(i => numbers[i]).Distinct().ToArray();
        if (own is not [> 0])
        {
            return own.Length > 1
                ? "the features are cut in several work offsets"
                : "the features are cut in a work offset that cannot be changed";
        }

        if (Own().Any(i => _path.Frames[_path.Motions[i].Frame].IsTransformed))
        {
            return "the features are cut under a rotation, scaling or mirroring of the program";
        }

        if (Own().Any(i => _path.Motions[i].Plane != CoordinatePlane.XY))
        {
            return "the features are cut in another plane than XY";
        }

        WorkOffsetNumber = own[0];
        return _correction.OtherCutsMayMove ? null : Other(i => numbers[i] == own[0] || numbers[i] < 0);
    }

    private string? Turns()
    {
        if (!OffsetProgram.CanRotate(_path.Dialect))
        {
            return "the control cannot rotate it";
        }

        return Own().Select(i => _path.Frames[_path.Motions[i].Frame]).Any(
            f => f.Shift != default || f.UnknownShift != AxisSet.None || f.ProgramShift != default)
            ? "it is not rotated, because the program shifts its origin"
            : null;
    }

    private string? Other(Func<int, bool> moves)
    {
        var other = OtherCuts.First(_path, _maps, moves);
        return other < 0 ? null
            : $"{_path.Program.NameOf(_path.Program[_path.Motions[other].Block])} belongs to no feature and would move, too; "
                + "\"otherCuts\": \"may-move\" allows it";
    }

    private IEnumerable<int> Own() =>
        _maps.SelectMany(m => m.Passes).SelectMany(p => FeaturePass.Moving(_path, p.First, p.Last));
}
