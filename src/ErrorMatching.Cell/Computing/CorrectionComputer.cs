using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Turns a recognized measurement into a program that may be proposed: the console's calculation for the same inputs, within the
/// limits of the policy. It reads the job's own files, uses no clock, and keeps no state between calls. Thread-safe.</summary>
/// <param name="policy">The cell's policy, for jobs without one of their own.</param>
public sealed class CorrectionComputer(PolicySettings policy)
{
    private const int MostReasons = 3;
    private const string Between = ": ";

    /// <summary>Determines the inputs of a correction, and its identity, without computing it.</summary>
    /// <param name="request">What it is computed from.</param>
    /// <returns><see cref="Identified"/>, or <see cref="RefusedComputation"/> if the job's files cannot be used or the part is not
    /// measured.</returns>
    /// <exception cref="ArgumentException">The request contradicts itself.</exception>
    public Computation Identify(CorrectionRequest request) => RefusingInputs(request, isAll: false, CancellationToken.None);

    /// <summary>Computes a correction.</summary>
    /// <param name="request">What it is computed from.</param>
    /// <param name="cancellation">Checked between the stages of the calculation.</param>
    /// <returns><see cref="ComputedProgram"/>, <see cref="NothingToSend"/> or <see cref="RefusedComputation"/>. No measurement,
    /// whatever its content, causes an exception.</returns>
    /// <exception cref="ArgumentException">The request contradicts itself.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public Computation Compute(CorrectionRequest request, CancellationToken cancellation) =>
        RefusingInputs(request, isAll: true, cancellation);

    private Computation RefusingInputs(CorrectionRequest request, bool isAll, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (!request.Job.Accumulates && (request.Base is not null || request.Previous is not null || request.Sums.Points.Count > 0))
        {
            throw new ArgumentException("Only a job that accumulates starts from another program than its original one.", nameof(request));
        }

        if (request.Base is null && request.Previous is null && request.Sums.Points.Count > 0)
        {
            throw new ArgumentException("The original program is not corrected yet, so it has no sums.", nameof(request));
        }

        var holds = request.Job.Policy ?? policy;
        try
        {
            var job = InputFile.Bytes(request.Job.File, JsonLimits.Default.MaxBytes);
            var computation = request.Piece switch
            {
                PieceWords.Part or PieceWords.Counterpart =>
                    isAll
                        ? new MatingCorrection(request, holds, job).Compute(cancellation)
                        : new MatingCorrection(request, holds, job).Identify(),
                PieceWords.Surface =>
                    isAll
                        ? new SurfaceCorrection(request, holds, job).Compute(cancellation)
                        : new SurfaceCorrection(request, holds, job).Identify(),
                _ =>
                    throw new ArgumentException(
                        $"Found the piece {request.Piece}; expected part, counterpart or surface.", nameof(request)),
            };
            return request.Identity is { } known && IdentityOf(computation) is { } now && known != now
                ? new RefusedComputation(CorrectionCodes.JobChanged, Recorded.JobChanged.With(request.Job.Name))
                : computation;
        }
        catch (InputException e)
        {
            return Refused(e.Refusals, Stated);
        }
    }

    /// <summary>A refusal for a list of errors: the first code, and the reasons in order.</summary>
    internal static RefusedComputation Refused(IReadOnlyList<Refusal> items) =>
        Refused(items, r => r.Place.Path is null ? RefusalForms.StatementOf(r) : Stated(r));

    // The correction names its job and program; only a place inside the job adds to that.
    private static RefusedComputation Refused(IReadOnlyList<Refusal> items, Func<Refusal, Statement> stated) => new(
        items[0].Code,
        Statement.InARow([
            .. items.Take(MostReasons).Select(stated),
            items.Count > MostReasons ? Recorded.AndMore.With(items.Count - MostReasons) : ""]))
    {
        Block = items[0].Place.Block,
        MayPass = items[0].Code == MeasurementError.FileUnreadable,
    };

    // With its place in front, as in its sentence.
    private static Statement Stated(Refusal refusal) =>
        RefusalForms.StatementOf(refusal) is not { IsCoded: true } statement ? refusal.Sentence
        : refusal.Sentence == refusal.Message ? statement
        : Recorded.AtPlace.With(refusal.Sentence[..^(Between.Length + refusal.Message.Length)], statement);

    private static string? IdentityOf(Computation computation) => computation switch
    {
        Identified identified => identified.Basis.Identity,
        ComputedProgram computed => computed.Basis.Identity,
        NothingToSend nothing => nothing.Basis.Identity,
        _ => null,
    };
}
