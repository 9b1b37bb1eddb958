using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>
/// The forms of what the cell writes into steps, reasons and the audit trail. What is recorded is evidence and stays as it was written; who shows it in another language reads it back by these forms.
/// </summary>
/// <remarks>
/// Kinds of values: a number's format; <c>word</c> for one of a few words; <c>amount</c> for one of these or a number with its unit; <c>state</c> for a state of a correction; <c>any</c> for another sentence of the cell or a foreign one; and the beginning of a name, such as <c>at</c>, for
/// one or several sentences (with "; " between them) whose form is called so.
/// </remarks>
public static class Recorded
{
    /// <summary>How far a program moves at most, in mm, and where.</summary>
    public static SentenceForm DisplacedAt { get; } = new("displaced-at", "displaced by at most {0:0.0000} mm at {1:at}.");

    // How a correction goes on.
    internal static readonly SentenceForm Arrived = new("arrived", "arrived from {0} as {1}");
    internal static readonly SentenceForm OfCutAndPart = new("of-cut-and-part", "{0:word} of {1}, cut by the program of correction {2:0}, to be compared with the part of correction {3:0}");
    internal static readonly SentenceForm OfCut = new("of-cut", "{0:word} of {1}, cut by the program of correction {2:0}");
    internal static readonly SentenceForm OfPart = new("of-part", "{0:word} of {1}, to be compared with the part of correction {2:0}");
    internal static readonly SentenceForm Of = new("of", "{0:word} of {1}");
    internal static readonly SentenceForm DisplacedNothing = new("displaced-nothing", "nothing is to be displaced.");
    internal static readonly SentenceForm DisplacedInSum = new("displaced-in-sum", "displaced by at most {0:0.0000} mm, {1:0.0000} mm since the original");
    internal static readonly SentenceForm Displaced = new("displaced", "displaced by at most {0:0.0000} mm");
    internal static readonly SentenceForm Computed = new("computed", "computed");
    internal static readonly SentenceForm AtPointOf = new("at-point-of", "point {0} of {1}");
    internal static readonly SentenceForm AtPointAndBeside = new("at-point-and-beside", "point {0} and beside it");
    internal static readonly SentenceForm AtPoint = new("at-point", "point {0}");
    internal static readonly SentenceForm AtBlock = new("at-block", "block {0}");
    internal static readonly SentenceForm PolicyWithin = new("policy-within", "policy: automatic within {0} mm");
    internal static readonly SentenceForm Policy = new("policy", "policy: automatic");
    internal static readonly SentenceForm NewerMeasurement = new("newer-measurement", "correction {0:0} is a newer measurement of {1}");
    internal static readonly SentenceForm NewerOfSamePiece = new("newer-of-same-piece", "Correction {0:0} ({1}) is a newer measurement of the same piece.");
    internal static readonly SentenceForm GivenAgain = new("given-again", "given again in the place of correction {0:0}, to be computed with the job as it is now");
    internal static readonly SentenceForm ComputedAnew = new("computed-anew", "Its job was changed after it was made: correction {0:0} computes the measurement anew, with the job as it is now.");
    internal static readonly SentenceForm FirstArticle = new("first-article", "A counterpart is measured: this verifies what was sent, and sends nothing.");
    internal static readonly SentenceForm NotCompared = new("not-compared", "It was compared with nothing, for no program was sent for a part of its number.");
    internal static readonly SentenceForm NotComparable = new("not-comparable", "It could not be compared with its part: {0:any}");
    internal static readonly SentenceForm PartRecorded = new("part-recorded", "The part is measured; its counterparts are compared with it.");
    internal static readonly SentenceForm Approved = new("approved", "approved");
    internal static readonly SentenceForm PieceCut = new("piece-cut", "the piece is cut");
    internal static readonly SentenceForm SlotUsable = new("slot-usable", "the slot may be used again");

    // At the machine.
    internal static readonly SentenceForm LookedAtBase = new("looked-at-base", "looked at what it adds to");
    internal static readonly SentenceForm TriedToRead = new("tried-to-read", "tried to read what the slot holds");
    internal static readonly SentenceForm SlotEmpty = new("slot-empty", "the slot was empty");
    internal static readonly SentenceForm SlotHeld = new("slot-held", "the slot held {0}");
    internal static readonly SentenceForm CellStopped = new("cell-stopped", "the cell was stopped");
    internal static readonly SentenceForm HeldAfterCut = new("held-after-cut", "the machine held it after a cut");
    internal static readonly SentenceForm ReadBack = new("read-back", "read back from the machine, the same to the last bit");
    internal static readonly SentenceForm GivenBack = new("given-back", "given back: {0:any}");
    internal static readonly SentenceForm MachineWrote = new("machine-wrote", "the machine wrote {0}");
    internal static readonly SentenceForm EitherProgram = new("either-program", "{0:any} The slot may hold the program before or this one.");
    internal static readonly SentenceForm ChangedBefore = new(
        "changed-before", "{0} at {1} is neither what the cell put there nor an original: somebody changed it. It is kept as {2}. Look at it, then approve again to replace it, or reject.");
    internal static readonly SentenceForm ChangedMeanwhile = new(
        "changed-meanwhile", "{0} at {1} changed while it was being replaced: it is neither the program before nor the one to send. It is kept as {2}. Look at it, then approve again to replace it, or reject.");

    // Why a measurement is refused, or nothing is sent.
    internal static readonly SentenceForm UnknownPiece = new("unknown-piece", "No job takes \"{0}\" from \"{1}\": {2:asked}.");
    internal static readonly SentenceForm AskedNobody = new("asked-nobody", "no job listens to this gauge");
    internal static readonly SentenceForm AskedWants = new("asked-wants", "\"{0}\" wants {1:like}");
    internal static readonly SentenceForm LikeAll = new("like-all", "{0:like} and {1:like}");
    internal static readonly SentenceForm LikeName = new("like-name", "a file name like {0}");
    internal static readonly SentenceForm LikeField = new("like-field", "a field {0} like {1}");
    internal static readonly SentenceForm LikeColumn = new("like-column", "a column {0} like {1}");
    internal static readonly SentenceForm AmbiguousPiece = new("ambiguous-piece", "Several jobs take \"{0}\": {1}. Make their patterns narrower.");
    internal static readonly SentenceForm ContradictoryPiece = new("contradictory-piece", "\"{0}\" says two things about its piece: {1:says}.");
    internal static readonly SentenceForm SaysNoName = new("says-no-name", "its {0:word} is empty, longer than {1:0} characters, or no printable text");
    internal static readonly SentenceForm SaysTwo = new("says-two", "the {0:word}s \"{1}\" and \"{2}\"");
    internal static readonly SentenceForm UnusableJob = new("unusable-job", "The job {0} cannot be used any more, so nobody can tell whose measurement \"{1}\" is: {2:any}");
    internal static readonly SentenceForm UnreadableInside = new("unreadable-inside", "The patterns of the jobs must look into \"{0}\", which cannot be read: {1:any}");
    // No longer written: stores have it from when expressions had a limit by the clock.
    internal static readonly SentenceForm SlowPattern = new("slow-pattern", "A pattern takes too long on \"{0}\": {1}. Make it simpler.");
    internal static readonly SentenceForm TooLarge = new(
        "too-large", "The file has {0:0} bytes, and \"{1}\" takes at most {2:0}. It lies in {3} under its hash. Is it a measurement at all? If so, raise mostMB of the gauge and put it into {4} again.");
    internal static readonly SentenceForm AlreadyKnown = new("already-known", "Correction {0:0} ({1}, {2:state}) has the same measurement, job and program: a correction is applied once.");
    internal static readonly SentenceForm SumsUnknown = new(
        "sums-unknown", "The piece was cut by the program of correction {0:0}, which was made when the job {1} did not accumulate: nobody knows its sums. Revert that correction, and begin from the original.");
    internal static readonly SentenceForm PartOfNumberUnmeasured = new(
        "part-of-number-unmeasured",
        "The counterpart with {0:named} is compared with its part, and no part with {1:named} is measured. Measure that part, then give {2} again; if the two pieces have other numbers, let the job's patterns read only what both of them say.");
    internal static readonly SentenceForm NamedBoth = new("named-both", "serial number {0} and work order {1}");
    internal static readonly SentenceForm NamedSerial = new("named-serial", "serial number {0}");
    internal static readonly SentenceForm NamedOrder = new("named-order", "work order {0}");
    internal static readonly SentenceForm PartUnmeasured = new("part-unmeasured", "The counterpart is compared with its part, and no measurement of the part is there. Measure the part, then give {0} again.");
    internal static readonly SentenceForm NotReleasedReverted = new(
        "not-released-reverted",
        "Correction {0:0} was reverted and still has slot {1} of {2}: nobody knows whether its program cut the measured piece or the one that was brought back. Release it when a piece is cut with what is there now (errormatch cell release CONFIG {3:0}), then measure that piece.");
    internal static readonly SentenceForm NotReleased = new(
        "not-released",
        "Correction {0:0} has slot {1} of {2}, and nobody has said that its piece is cut: nobody knows whether its program cut the measured piece or the one before. When its piece is cut, release it (errormatch cell release CONFIG {3:0}), then give the measurement again.");
    internal static readonly SentenceForm BaseReverted = new(
        "base-reverted",
        "It adds to the program of correction {0:0}, which was reverted meanwhile ({1}). Nothing that is built on it is sent: reject this one if it still waits, and measure a piece that was cut with the program that is there now.");
    internal static readonly SentenceForm NotFeedback = new(
        "not-feedback", "The job {0} shall accumulate, but it compensates the part: only what the program itself cut adds up. Take accumulates out, or let compensation.from be the counterpart.");
    internal static readonly SentenceForm NotFeedbackSurface = new("not-feedback-surface", "The job {0} shall accumulate, but a surface is always compensated from its nominal shape. Take accumulates out.");
    internal static readonly SentenceForm JobChanged = new("job-changed", "The files of the job {0} were changed after the measurement was recognized. Give the measurement again.");
    internal static readonly SentenceForm OriginalChanged = new(
        "original-changed",
        "The original program {0} has other motions than the one that cut the piece, so nobody can tell by how much that one is corrected in all: the original was changed since. Revert the corrections that were sent, and begin from the new original.");
    internal static readonly SentenceForm OverLimit = new(
        "over-limit", "At {0:at} the program would move by {1:0.0000} mm; the policy allows {2:0.####} mm in one step. Look for a wrong part, a chip or a wrong probe; if the piece really is so, a setter raises limitMm.");
    internal static readonly SentenceForm OverSumLimit = new(
        "over-sum-limit",
        "At {0:at} the program would lie {1:0.0000} mm from the original one; the policy allows {2:0.####} mm in sum. Find out why errors add up: worn tool, drift, wrong clamping. If it is meant, a setter raises sumLimitMm.");
    internal static readonly SentenceForm AndMore = new("and-more", "And {0:0} more.");
    internal static readonly SentenceForm Defect = new("defect", "This is a defect of errormatch: please report it with the file. {0}: {1}");

    // People and their passwords.
    internal static readonly SentenceForm FirstAdministrator = new("first-administrator", "the first administrator, made by who can write the store");
    internal static readonly SentenceForm SignedIn = new("signed-in", "by password, as {0:word}");
    internal static readonly SentenceForm AsRole = new("as-role", "as {0:word}");
    internal static readonly SentenceForm ToRole = new("to-role", "to {0:word}");
    internal static readonly SentenceForm UntilUtc = new("until-utc", "{0:wrong}; until {1:yyyy-MM-dd HH:mm:ss} UTC");
    internal static readonly SentenceForm WrongPassword = new("wrong-password", "wrong password, {0:0} in a row");
    internal static readonly SentenceForm WrongDisabled = new("wrong-disabled", "the user is disabled");
    internal static readonly SentenceForm NoSuchName = new("no-such-name", "no user has this name");
    internal static readonly SentenceForm NoSuchNames = new("no-such-names", "no user has this name; further names of nobody are not recorded within the hour");
    internal static readonly SentenceForm ByHand = new("by-hand", "by hand");
    internal static readonly SentenceForm Idle = new("idle", "idle");

    // The store, and what an entry is about.
    internal static readonly SentenceForm StoreMade = new("store-made", "The store was made.");
    internal static readonly SentenceForm FromBackup = new("from-backup", "from the backup {0}");
    internal static readonly SentenceForm KeptAside = new("kept-aside", "what was there before is {0}");
    internal static readonly SentenceForm SetBack = new("set-back", "{0:any} It had gone to entry {1:0} with the hash {2}.");
    internal static readonly SentenceForm JobInPlace = new("job-in-place", "{0}, in place of the job {1}");
    internal static readonly SentenceForm Program = new("program", "correction {0:0} program {1}");
    internal static readonly SentenceForm File = new("file", "correction {0:0} file {1}");
    internal static readonly SentenceForm Correction = new("correction", "correction {0:0}");
    internal static readonly SentenceForm Slot = new("slot", "slot {0} of {1}");

    /// <summary>A backup was brought back: its file.</summary>
    public static SentenceForm BackupBroughtBack { get; } = new("backup-brought-back", "A backup was brought back: {0}.");

    /// <summary>A cell was started: SHA-256 of its configuration, and the policies in force.</summary>
    public static SentenceForm Started { get; } = new("started", "configuration {0}; {1:policies}");

    /// <summary>The policy of a cell: who approves, limit, limit of the sum, and gain.</summary>
    public static SentenceForm PoliciesOfCell { get; } = new("policies-of-cell", "policy {0:word}, limit {1:amount}, sum {2:amount}, gain {3:amount}");

    /// <summary>The policy of a job: its name, who approves, limit, limit of the sum, and gain.</summary>
    public static SentenceForm PoliciesOfJob { get; } = new("policies-of-job", "{0}: {1:word}, limit {2:amount}, sum {3:amount}, gain {4:amount}");

    /// <summary>A cell was stopped.</summary>
    public static SentenceForm Stopped { get; } = new("stopped", "told to stop");

    /// <summary>All forms; of two that fit a sentence the first is meant.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
    [
        Arrived, OfCutAndPart, OfCut, OfPart, Of, DisplacedAt, DisplacedNothing, DisplacedInSum, Displaced, Computed, AtPointOf, AtPointAndBeside,
        AtPoint, AtBlock, PolicyWithin, Policy, NewerMeasurement, NewerOfSamePiece, GivenAgain, ComputedAnew, FirstArticle, NotCompared, NotComparable, PartRecorded, Approved,
        PieceCut, SlotUsable, LookedAtBase, TriedToRead, SlotEmpty, SlotHeld, CellStopped, HeldAfterCut, ReadBack, GivenBack, MachineWrote,
        EitherProgram, ChangedBefore, ChangedMeanwhile, UnknownPiece, AskedNobody, AskedWants, LikeAll, LikeName, LikeField, LikeColumn,
        AmbiguousPiece, ContradictoryPiece, SaysNoName, SaysTwo, UnusableJob, UnreadableInside, SlowPattern, TooLarge, AlreadyKnown, SumsUnknown,
        PartOfNumberUnmeasured, NamedBoth, NamedSerial, NamedOrder, PartUnmeasured, NotReleasedReverted, NotReleased, BaseReverted, NotFeedback,
        NotFeedbackSurface, JobChanged, OriginalChanged, OverLimit, OverSumLimit, AndMore, Defect, FirstAdministrator, SignedIn, AsRole, ToRole, UntilUtc,
        WrongPassword, WrongDisabled, NoSuchName, NoSuchNames, ByHand, Idle, StoreMade, FromBackup, KeptAside, SetBack, JobInPlace, Program, File,
        Correction, Slot, BackupBroughtBack, Started, PoliciesOfCell, PoliciesOfJob, Stopped,
    ];
}
