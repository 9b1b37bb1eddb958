using System.Security.Cryptography;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Compares two measured counterparts with the part: normals from the program, points aligned as the job says, then <see cref="Verifier"/>.</summary>
public static class VerifyRun
{
    /// <summary>Makes the report of a verification.</summary>
    /// <param name="input">What it is computed from.</param>
    /// <param name="refusals">Why nothing can be compared: an origin that is off, or features that are not on the program; empty where there is a report.</param>
    /// <exception cref="MeasurementException">A measurement lacks a point or coordinate.</exception>
    /// <exception cref="GeometryException">The points of a feature do not determine it; the message names it.</exception>
    /// <exception cref="NcException">The dialect or a selector cannot be read.</exception>
    public static VerifyReport? Report(VerifyInput input, out IReadOnlyList<MatingRefusal> refusals)
    {
        ArgumentNullException.ThrowIfNull(input);
        var job = input.Job;
        var path = NcInterpreter.Run(NcProgram.Read(input.Program), input.OwnDialect ?? NcDialects.Named(job.Counterpart.Dialect));
        IReadOnlyList<FeatureMap> maps = [];
        if ((MatingRefusal.OfPath(path) ?? OriginCheck.Refuse(job, input.Theoretical, input.Part, input.Before, input.After) ?? AlignedMeasurement.Check(job) ?? FeatureMapper.Map(job, path, input.Theoretical, out maps)) is { } refusal)
        {
            refusals = [refusal];
            return null;
        }

        refusals = [];
        var part = AlignedMeasurement.Of(job, maps, input.Theoretical, input.Part, MeasuredPiece.Part);
        var before = AlignedMeasurement.Of(job, maps, input.Theoretical, input.Before, MeasuredPiece.Counterpart);
        var after = AlignedMeasurement.Of(job, maps, input.Theoretical, input.After, MeasuredPiece.Counterpart);
        var points = maps.Select(m => (IReadOnlyList<VerifiedPoint>)[.. m.Feature.Points.Select((l, i) => new VerifiedPoint(l, part.Points[l], before.Points[l], after.Points[l], m.Normals[i]))]);
        ReportInput[] inputs =
        [
            new("theoretical", input.Theoretical.File, input.Theoretical.Sha256),
            new("part", input.Part.File, input.Part.Sha256),
            new("counterpart", input.Before.File, input.Before.Sha256),
            new("counterpart-after", input.After.File, input.After.Sha256),
            new("program", input.ProgramFile, Convert.ToHexStringLower(SHA256.HashData(input.Program.Span))),
            .. path.Dialect.Files.Select(f => new ReportInput("dialect", f.File, f.Sha256)),
        ];
        return new(new ReportJob(job.Name, job.WorkOrder, job.File, job.Sha256), inputs, Verifier.Verify(job, [.. points]), []);
    }
}
