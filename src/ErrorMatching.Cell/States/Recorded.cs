using System.Collections.Frozen;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The forms of what the cell states in steps, reasons and the audit trail: a code with its values. Sentences are made where they
/// are shown.</summary>
public static class Recorded
{
    /// <summary>A program's largest displacement, in mm, and where it is.</summary>
    public static SentenceForm DisplacedAt { get; } = new("displaced-at", "displaced by at most {0:0.0000} mm at {1}.");

    /// <summary>A key point and its feature.</summary>
    public static SentenceForm AtPointOf { get; } = new("at-point-of", "point {0} of {1}");

    /// <summary>A key point.</summary>
    public static SentenceForm AtPoint { get; } = new("at-point", "point {0}");

    /// <summary>A block.</summary>
    public static SentenceForm AtBlock { get; } = new("at-block", "block {0}");

    // Steps of a correction.
    internal static readonly SentenceForm Arrived = new("arrived", "arrived from {0} as {1}");
    internal static readonly SentenceForm OfCutAndPart = new(
        "of-cut-and-part", "{0:word} of {1}, cut by the program of correction {2:0}, to be compared with the part of correction {3:0}");
    internal static readonly SentenceForm OfCut = new("of-cut", "{0:word} of {1}, cut by the program of correction {2:0}");
    internal static readonly SentenceForm OfPart = new("of-part", "{0:word} of {1}, to be compared with the part of correction {2:0}");
    internal static readonly SentenceForm Of = new("of", "{0:word} of {1}");
    internal static readonly SentenceForm DisplacedNothing = new("displaced-nothing", "nothing is to be displaced.");
    internal static readonly SentenceForm DisplacedInSum = new(
        "displaced-in-sum", "displaced by at most {0:0.0000} mm, {1:0.0000} mm since the original");
    internal static readonly SentenceForm Displaced = new("displaced", "displaced by at most {0:0.0000} mm");
    internal static readonly SentenceForm Computed = new("computed", "computed");
    internal static readonly SentenceForm NotToCut = new("not-to-cut", "Its verdict does not say to cut it: a person decides.");
    internal static readonly SentenceForm AtPointAndBeside = new("at-point-and-beside", "point {0} and beside it");
    internal static readonly SentenceForm PolicyWithin = new("policy-within", "policy: automatic within {0} mm");
    internal static readonly SentenceForm Policy = new("policy", "policy: automatic");
    internal static readonly SentenceForm NewerMeasurement = new("newer-measurement", "correction {0:0} is a newer measurement of {1}");
    internal static readonly SentenceForm NewerOfSamePiece = new(
        "newer-of-same-piece", "Correction {0:0} ({1}) is a newer measurement of the same piece.");

    // A recalculation: the new correction and the one that it ends. The names are stored, so that they stay as they were.
    internal static readonly SentenceForm RecalculationOf = new(
        "given-again", "given again in the place of correction {0:0}, to be computed with the job as it is now");
    internal static readonly SentenceForm RecalculatedBy = new(
        "computed-anew",
        "Its job was changed after it was made: correction {0:0} recalculates the measurement with the job as it is now.");

    internal static readonly SentenceForm FirstArticle = new(
        "first-article", "A counterpart is measured: this verifies what was sent, and sends nothing.");
    internal static readonly SentenceForm VerifiedWithin = new(
        "verified-within", "{0:0} of {1:0} points are within their limits.");
    internal static readonly SentenceForm VerifiedOutside = new(
        "verified-outside", "{0:0} of {1:0} points are outside their limits: {2}.");
    internal static readonly SentenceForm NotCompared = new(
        "not-compared", "It was compared with nothing, for no program was sent for a part of its number.");
    internal static readonly SentenceForm NotComparable = new("not-comparable", "It could not be compared with its part: {0}");
    internal static readonly SentenceForm PartRecorded = new(
        "part-recorded", "The part is measured; its counterparts are compared with it.");
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
    internal static readonly SentenceForm GivenBack = new("given-back", "given back: {0}");
    internal static readonly SentenceForm MachineWrote = new("machine-wrote", "the machine wrote {0}");
    internal static readonly SentenceForm EitherProgram = new(
        "either-program", "{0} The slot may hold the program before or this one.");
    internal static readonly SentenceForm ChangedBefore = new(
        "changed-before",
        "{0} at {1} is neither what the cell put there nor an original: somebody changed it. It is kept as {2}. Look at it, then approve "
            + "again to replace it, or reject.");
    internal static readonly SentenceForm OfOtherCell = new(
        "of-other-cell",
        "{0} at {1} is a corrected program that this cell did not make: another cell sends to this slot, too, or somebody copied it there. "
            + "It is kept as {2}. Give the slot to one cell alone; then approve again to replace it, or reject.");
    internal static readonly SentenceForm ChangedMeanwhile = new(
        "changed-meanwhile",
        "{0} at {1} changed while it was being replaced: it is neither the program before nor the one to send. It is kept as {2}. Look "
            + "at it, then approve again to replace it, or reject.");

    internal static readonly SentenceForm NamedOtherwise = new(
        "named-otherwise",
        "The program for {0} at {1} is {2} at its head: the control would call it so, whatever the file is called. Nothing was sent. Give "
            + "the slot's file and the job's program the same name or number, then approve again.");
    internal static readonly SentenceForm NamedOtherwiseThere = new(
        "named-otherwise-there",
        "{0} at {1} is {2} at its head, and the program to send is {3}: the control would no longer have the first of them. Nothing was "
            + "sent. Look whether that is meant; then approve again, or reject.");
    internal static readonly SentenceForm NameOfSlot = new(
        "name-of-slot",
        "The control would call the program for {0} at {1} by {2}, and so it calls a program of slot {3}. Nothing was sent. Give each "
            + "program a name and a number of its own, then approve again.");
    internal static readonly SentenceForm NameOfJob = new(
        "name-of-job",
        "The control would call the program for {0} at {1} by {2}, and so it calls the program {3} of the job {4}, which is at the "
            + "machine, too. Nothing was sent. Give each program a name and a number of its own, then approve again.");
    internal static readonly SentenceForm NameOfFile = new(
        "name-of-file",
        "The control would call the program for {0} at {1} by {2}, and the file {3} at the machine has that name, too. Nothing was sent. "
            + "Look which of them is meant, remove or rename the other, then approve again.");

    internal static readonly SentenceForm ChangedTwice = new(
        "changed-twice",
        "{0} at {1} was changed in the very moment in which it was replaced, and what was there before is beside it as {2}: "
        + "the cell knows neither of them. Look at both, remove the second, then approve again to replace the first, or reject.");
    internal static readonly SentenceForm ChangedWhileHeld = new(
        "changed-while-held",
        "{0} at {1} is not the program of correction {2:0} any more, which was verified there, but {3}: somebody changed it. "
        + "It is not released by itself. Look at it; then release with a reason, or put the program back.");
    internal static readonly SentenceForm HeldAgain = new("held-again", "{0} at {1} is the program of correction {2:0} again.");
    internal static readonly SentenceForm AnswersAgain = new("answers-again", "{0} answers again.");

    // Why a measurement is refused, or nothing is sent.
    internal static readonly SentenceForm ReadBackUnseen = new(
        "read-back-unseen",
        "read back from the machine and the same to the last bit; whether it was started meanwhile is not known: {0}");
    internal static readonly SentenceForm MachineBusy = new(
        "machine-busy",
        "{0} is {1:word} with the program {2}. {3} is replaced as soon as the machine is idle or runs another program.");
    internal static readonly SentenceForm MachineBusyUnnamed = new(
        "machine-busy-unnamed",
        "{0} is {1:word} and does not say with which program. {2} is replaced as soon as the machine is idle.");
    internal static readonly SentenceForm MachineUnknown = new(
        "machine-unknown", "What {0} is doing is not known. {1} is replaced as soon as the machine says that it is idle: {2}");
    internal static readonly SentenceForm WaitsTooLong = new(
        "waits-too-long", "Correction {0:0} has waited for the machine since {1:yyyy-MM-dd HH:mm} UTC. {2}");
    internal static readonly SentenceForm BacklogGrows = new(
        "backlog-grows",
        "What waits has grown for a minute: more arrives than the cell computes. Files at the gauge {0}: {1:0}. Measurements that are not "
            + "computed: {2:0}.");
    internal static readonly SentenceForm PieceWaits = new(
        "piece-waits",
        "The oldest measurement has waited since {0:yyyy-MM-dd HH:mm} UTC, and {1:0.##} min are allowed. Files at the gauge {2}: {3:0}. "
            + "Measurements that are not computed: {4:0}.");
    internal static readonly SentenceForm StartedMeanwhile = new(
        "started-meanwhile",
        "{0} started {1} while it was being replaced: it may run the old program or the new one. Find out at the "
            + "machine which one it runs; then approve or revert the correction again.");
    internal static readonly SentenceForm StateAway = new("state-away", "{0} does not answer: {1}.");
    internal static readonly SentenceForm StateSlow = new("state-slow", "{0} did not answer within {1:0.#} s.");
    internal static readonly SentenceForm StateWrong = new("state-wrong", "{0} answered what the cell does not understand: {1}.");
    internal static readonly SentenceForm StateStale = new(
        "state-stale", "What {0} says is {1:0} s old, and at most {2:0} s are allowed. Does whoever writes it still run?");
    internal static readonly SentenceForm StateUnavailable = new(
        "state-unavailable", "{0} has no value for {1}. Is the machine switched on?");
    internal static readonly SentenceForm UnknownPiece = new("unknown-piece", "No job takes \"{0}\" from \"{1}\": {2:list; }.");
    internal static readonly SentenceForm AskedNobody = new("asked-nobody", "no job listens to this gauge");
    internal static readonly SentenceForm AskedWants = new("asked-wants", "\"{0}\" wants {1}");
    internal static readonly SentenceForm LikeAll = new("like-all", "{0} and {1}");
    internal static readonly SentenceForm LikeName = new("like-name", "a file name like {0}");
    internal static readonly SentenceForm LikeField = new("like-field", "a field {0} like {1}");
    internal static readonly SentenceForm LikeColumn = new("like-column", "a column {0} like {1}");
    internal static readonly SentenceForm AmbiguousPiece = new(
        "ambiguous-piece", "Several jobs take \"{0}\": {1}. Make their patterns narrower.");
    internal static readonly SentenceForm ContradictoryPiece = new(
        "contradictory-piece", "\"{0}\" says two things about its piece: {1}.");
    internal static readonly SentenceForm SaysNoName = new(
        "says-no-name", "its {0:word} is empty, longer than {1:0} characters, or no printable text");
    internal static readonly SentenceForm SaysTwo = new("says-two", "the {0:word}s \"{1}\" and \"{2}\"");
    internal static readonly SentenceForm UnusableJob = new(
        "unusable-job", "The job {0} cannot be used any more, so nobody can tell whose measurement \"{1}\" is: {2}");
    internal static readonly SentenceForm UnreadableInside = new(
        "unreadable-inside", "The patterns of the jobs must look into \"{0}\", which cannot be read: {1}");
    internal static readonly SentenceForm TooLarge = new(
        "too-large",
        "The file has {0:0} bytes, and \"{1}\" takes at most {2:0}. It lies in {3} under its hash. Is it a measurement at all? If so, "
            + "raise mostMB of the gauge and put it into {4} again.");
    internal static readonly SentenceForm AlreadyKnown = new(
        "already-known", "Correction {0:0} ({1}, {2:state}) has the same measurement, job and program: a correction is applied once.");
    internal static readonly SentenceForm SumsUnknown = new(
        "sums-unknown",
        "The piece was cut by the program of correction {0:0}, which was made when the job {1} did not accumulate: nobody knows its "
            + "sums. Revert that correction, and begin from the original.");
    internal static readonly SentenceForm PartOfNumberUnmeasured = new(
        "part-of-number-unmeasured",
        "The counterpart with {0} is compared with its part, and no part with {1} is measured. Measure that part, then give "
            + "{2} again; if the two pieces have other numbers, let the job's patterns read only what both of them say.");
    internal static readonly SentenceForm NamedBoth = new("named-both", "serial number {0} and work order {1}");
    internal static readonly SentenceForm NamedSerial = new("named-serial", "serial number {0}");
    internal static readonly SentenceForm NamedOrder = new("named-order", "work order {0}");
    internal static readonly SentenceForm PartUnmeasured = new(
        "part-unmeasured",
        "The counterpart is compared with its part, and no measurement of the part is there. Measure the part, then give {0} again.");
    internal static readonly SentenceForm NotReleasedReverted = new(
        "not-released-reverted",
        "Correction {0:0} was reverted and still has slot {1} of {2}: nobody knows whether its program cut the measured piece or the one "
            + "that was brought back. Release it when a piece is cut with what is there now (errormatch cell release CONFIG {3:0}), "
            + "then measure that piece.");
    internal static readonly SentenceForm NotReleased = new(
        "not-released",
        "Correction {0:0} has slot {1} of {2}, and nobody has said that its piece is cut: nobody knows whether its program cut the "
            + "measured piece or the one before. When its piece is cut, release it (errormatch cell release CONFIG {3:0}), then give "
            + "the measurement again.");
    internal static readonly SentenceForm BaseReverted = new(
        "base-reverted",
        "It adds to the program of correction {0:0}, which was reverted meanwhile ({1}). Nothing that is built on it is sent: reject "
            + "this one if it still waits, and measure a piece that was cut with the program that is there now.");
    internal static readonly SentenceForm NotFeedback = new(
        "not-feedback",
        "The job {0} shall accumulate, but it compensates the part: only what the program itself cut adds up. Take accumulates out, or "
            + "let compensation.from be the counterpart.");

    // Only older versions recorded this: surfaces go on from the report before.
    internal static readonly SentenceForm NotFeedbackSurface = new(
        "not-feedback-surface",
        "The job {0} shall accumulate, but a surface is always compensated from its nominal shape. Take accumulates out.");
    internal static readonly SentenceForm JobChanged = new(
        "job-changed", "The files of the job {0} were changed after the measurement was recognized. Give the measurement again.");
    internal static readonly SentenceForm OriginalChanged = new(
        "original-changed",
        "The original program {0} has other motions than the one that cut the piece, so nobody can tell by how much that one is "
            + "corrected in all: the original was changed since. Revert the corrections that were sent, and begin from the new "
            + "original.");
    internal static readonly SentenceForm OverLimit = new(
        "over-limit",
        "At {0} the program would move by {1:0.0000} mm; the policy allows {2:0.####} mm in one step. Look for a wrong part, a chip "
            + "or a wrong probe; if the piece really is so, a setter raises limitMm.");
    internal static readonly SentenceForm OverSumLimit = new(
        "over-sum-limit",
        "At {0} the program would lie {1:0.0000} mm from the original one; the policy allows {2:0.####} mm in sum. Find out why "
            + "errors add up: worn tool, drift, wrong clamping. If it is meant, a setter raises sumLimitMm.");
    internal static readonly SentenceForm AtPlace = new("at-place", "{0}: {1}");
    internal static readonly SentenceForm AndMore = new("and-more", "And {0:0} more.");
    internal static readonly SentenceForm Defect = new(
        "defect", "This is a defect of errormatch: please report it with the file. {0}: {1}");

    // People and their passwords.
    internal static readonly SentenceForm FirstAdministrator = new(
        "first-administrator", "the first administrator, made by who can write the store");
    internal static readonly SentenceForm SignedIn = new("signed-in", "by password, as {0:word}");
    internal static readonly SentenceForm SignedInByPin = new("signed-in-by-pin", "by PIN, as {0:word}");
    internal static readonly SentenceForm SignedInByBadge = new("signed-in-by-badge", "by badge, as {0:word}");
    internal static readonly SentenceForm SignedInByBadgeAndPin = new("signed-in-by-badge-and-pin", "by badge and PIN, as {0:word}");
    internal static readonly SentenceForm AsRole = new("as-role", "as {0:word}");
    internal static readonly SentenceForm ToRole = new("to-role", "to {0:word}");
    internal static readonly SentenceForm UntilUtc = new("until-utc", "{0}; until {1:yyyy-MM-dd HH:mm:ss} UTC");
    internal static readonly SentenceForm WrongPassword = new("wrong-password", "wrong password, {0:0} in a row");
    internal static readonly SentenceForm WrongPin = new("wrong-pin", "wrong PIN, {0:0} in a row");
    internal static readonly SentenceForm NoSuchBadge = new("no-such-badge", "a badge of nobody, {0:0} in a row");
    internal static readonly SentenceForm WrongDisabled = new("wrong-disabled", "the user is disabled");
    internal static readonly SentenceForm NoSuchName = new("no-such-name", "no user has this name");
    internal static readonly SentenceForm NoSuchNames = new(
        "no-such-names", "no user has this name; further names of nobody are not recorded within the hour");
    internal static readonly SentenceForm ByHand = new("by-hand", "by hand");
    internal static readonly SentenceForm Idle = new("idle", "idle");

    // The store, and the subject of an entry.
    internal static readonly SentenceForm StoreMade = new("store-made", "The store was made.");
    internal static readonly SentenceForm FromBackup = new("from-backup", "from the backup {0}");
    internal static readonly SentenceForm StoredAside = new("kept-aside", "what was there before is {0}");
    internal static readonly SentenceForm SetBack = new("set-back", "{0} It had gone to entry {1:0} with the hash {2}.");
    internal static readonly SentenceForm WitnessBegun = new(
        "witness-begun", "How far the trail goes is remembered again from here: {0}");
    internal static readonly SentenceForm JobFiles = new("job-files", "{0:list, }");
    internal static readonly SentenceForm JobFile = new("job-file", "{0} {1}");
    internal static readonly SentenceForm JobInPlace = new("job-in-place", "{0}, in place of the job {1}");
    internal static readonly SentenceForm Program = new("program", "correction {0:0} program {1}");
    internal static readonly SentenceForm File = new("file", "correction {0:0} file {1}");
    internal static readonly SentenceForm Correction = new("correction", "correction {0:0}");
    internal static readonly SentenceForm Slot = new("slot", "slot {0} of {1}");

    // Changes to the store from outside the cell.
    internal static readonly SentenceForm RowsCoded = new(
        "rows-coded",
        "{0:0} rows that had no codes are what the audit trail says of them; from here on they carry codes.");
    internal static readonly SentenceForm CorrectionTampered = new(
        "correction-tampered",
        "Correction {0:0} is not as the cell left it: somebody else wrote to its row of the store. It is not sent. See "
        + "errormatch audit verify; then reject it, or restore a backup.");
    internal static readonly SentenceForm SlotTampered = new(
        "slot-tampered",
        "Slot {0} of {1} is not as the cell left it: somebody else wrote to its row of the store. Nothing is sent "
        + "there. See errormatch audit verify; then restore a backup.");
    internal static readonly SentenceForm UserTampered = new(
        "user-tampered",
        "The user {0} is not as the cell left it: somebody else wrote to its row of the store. This user may do nothing "
        + "until another administrator sets a new password (errormatch user password).");
    internal static readonly SentenceForm CredentialTampered = new(
        "credential-tampered",
        "The {0:word} of {1} is not as the cell left it: somebody else wrote to its row of the store. Nobody signs in with it until an "
        + "administrator sets another one or takes it away (errormatch user pin, errormatch user badge).");
    internal static readonly SentenceForm UserOfNoRole = new(
        "user-of-no-role",
        "The store says that the user {0} is \"{1}\", and there is no such role: it is operator, setter or administrator. This user may "
        + "do nothing until another administrator sets the role and a new password (errormatch user role, errormatch user password).");
    internal static readonly SentenceForm NotSent = new("not-sent", "It is not sent: {0}");
    internal static readonly SentenceForm NoCorrection = new(
        "no-correction",
        "Entry {0:0} is \"{1}\" of \"{2}\", which is no correction.");
    internal static readonly SentenceForm NeverArrived = new(
        "never-arrived",
        "Entry {0:0} makes correction {1:0} {2:state}, and no entry before it says that it arrived.");
    internal static readonly SentenceForm StepNotAllowed = new(
        "step-not-allowed",
        "Entry {0:0} makes correction {1:0} {2:state}, and it was {3:state}: from there no step leads to it.");
    internal static readonly SentenceForm ApprovalNotAllowed = new(
        "approval-not-allowed",
        "Entry {0:0} approves correction {1:0} by {2}, {3}. It takes the policy, or a setter or administrator.");
    internal static readonly SentenceForm NotByPolicy = new("who-not-by-policy", "and names no policy");
    internal static readonly SentenceForm WasNobody = new("who-was-nobody", "who was no user then");
    internal static readonly SentenceForm WasDisabled = new("who-was-disabled", "who was disabled then");
    internal static readonly SentenceForm WasOfRole = new("who-was-of-role", "who was {0:word} then, and this takes {1:word}");
    internal static readonly SentenceForm OtherProgram = new(
        "other-program",
        "Entry {0:0} is about correction {1:0} with the program {2}; the one that was computed is {3}.");
    internal static readonly SentenceForm UserNotAllowed = new("user-not-allowed", "Entry {0:0} ({1} of {2}) is by {3}, {4}.");
    internal static readonly SentenceForm UserUnknown = new(
        "user-unknown",
        "Entry {0:0} ({1} of {2}) does not fit what is recorded of this user before.");
    internal static readonly SentenceForm CorrectionUnrecorded = new(
        "correction-unrecorded",
        "Correction {0:0} ({1:state}) is in the store, and no entry of the audit trail says that it arrived.");
    internal static readonly SentenceForm StateDiffers = new(
        "state-differs",
        "Correction {0:0} is {1:state} in the store; entry {2:0} of the audit trail left it {3:state}.");
    internal static readonly SentenceForm ProgramDiffers = new(
        "program-differs",
        "Correction {0:0} has the program {1} in the store; by entry {2:0} of the audit trail it has {3}.");
    internal static readonly SentenceForm FileDiffers = new(
        "file-differs",
        "Correction {0:0} has the file {1} in the store; by the audit trail it came in with {2}.");
    internal static readonly SentenceForm CorrectionDiffers = new(
        "correction-differs",
        "The row of correction {0:0} is not the one that entry {1:0} of the audit trail left: something in it was "
        + "changed.");
    internal static readonly SentenceForm CorrectionMissing = new(
        "correction-missing",
        "Correction {0:0} is not in the store any more; entry {1:0} of the audit trail is about it.");
    internal static readonly SentenceForm SlotHeldByOther = new(
        "slot-held-by-other",
        "Slot {0} of {1} is held by correction {2:0} in the store, which is {3:state} by the audit trail and holds none.");
    internal static readonly SentenceForm SlotNotHeld = new(
        "slot-not-held",
        "Slot {0} of {1} is not held by correction {2:0} in the store, which is {3:state} and holds it by the audit "
        + "trail.");
    internal static readonly SentenceForm SlotDiffers = new(
        "slot-differs",
        "The row of slot {0} of {1} is not the one that entry {2:0} of the audit trail left: something in it was "
        + "changed, or it was removed.");
    internal static readonly SentenceForm UserUnrecorded = new(
        "user-unrecorded",
        "The user {0} is in the store, and no entry of the audit trail says who added it.");
    internal static readonly SentenceForm RoleDiffers = new(
        "role-differs",
        "The user {0} is {1} in the store; by entry {2:0} of the audit trail it is {3:word}.");
    internal static readonly SentenceForm DisabledDiffers = new(
        "disabled-differs",
        "The user {0} is {1:word} in the store; entry {2:0} of the audit trail says otherwise.");
    internal static readonly SentenceForm UserDiffers = new(
        "user-differs",
        "The row of the user {0} is not the one that entry {1:0} of the audit trail left: its password, name or times "
        + "were changed.");
    internal static readonly SentenceForm CredentialDiffers = new(
        "credential-differs",
        "The {0:word} of {1} is not the one that entry {2:0} of the audit trail left.");
    internal static readonly SentenceForm UserMissing = new(
        "user-missing",
        "The user {0} is not in the store any more; entry {1:0} of the audit trail is about it.");
    internal static readonly SentenceForm RowMissing = new(
        "row-missing",
        "The row of {0} is not in the store any more; entry {1:0} of the audit trail left it.");
    internal static readonly SentenceForm RowUnreadable = new(
        "row-unreadable",
        "The row of {0} {1} cannot be read: something in it is of a kind that the cell does not write.");
    internal static readonly SentenceForm ContentDiffers = new("content-differs", "Content {0} is not what was kept.");
    internal static readonly SentenceForm ContentMissing = new(
        "content-missing", "Content {0} of correction {1:0} is not in the store.");
    internal static readonly SentenceForm StepDiffers = new(
        "step-differs",
        "Step {0:0} of the store is not what entry {1:0} of the audit trail says: correction {2:0}, {3:state}.");
    internal static readonly SentenceForm StepUnrecorded = new("step-unrecorded", "The store has {0:0} steps; the audit trail has {1:0}.");
    internal static readonly SentenceForm FormDiffers = new("form-differs", "The database is not as the cell made it: {0}.");
    internal static readonly SentenceForm FormUnknown = new("form-unknown", "it has the {0} {1}, which the cell did not make");
    internal static readonly SentenceForm FormLacks = new("form-lacks", "it lacks the {0} {1}");
    internal static readonly SentenceForm FormOther = new("form-other", "its {0} {1} is another one");
    internal static readonly SentenceForm TrailBroken = new(
        "trail-broken",
        "The audit trail is not what was written, at entry {0:0}. Nothing is sent. See errormatch audit verify; then "
        + "restore a backup.");

    /// <summary>A backup was restored: its file.</summary>
    public static SentenceForm BackupBroughtBack { get; } = new("backup-brought-back", "A backup was brought back: {0}.");

    /// <summary>A cell was started: SHA-256 of its configuration, and the policies in force.</summary>
    public static SentenceForm Started { get; } = new("started", "configuration {0}; {1:list; }");

    /// <summary>The policy of a cell: who approves, limit, limit of the sum, and gain.</summary>
    public static SentenceForm PoliciesOfCell { get; } = new(
        "policies-of-cell", "policy {0:word}, limit {1:word}, sum {2:word}, gain {3:word}");

    /// <summary>The policy of a job: its name, who approves, limit, limit of the sum, and gain.</summary>
    public static SentenceForm PoliciesOfJob { get; } = new(
        "policies-of-job", "{0}: {1:word}, limit {2:word}, sum {3:word}, gain {4:word}");

    /// <summary>A cell was stopped.</summary>
    public static SentenceForm Stopped { get; } = new("stopped", "told to stop");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
    [
        Arrived, OfCutAndPart, OfCut, OfPart, Of, DisplacedAt, DisplacedNothing, DisplacedInSum, Displaced, Computed, AtPointOf,
        AtPointAndBeside,
        AtPoint, AtBlock, PolicyWithin, Policy, NewerMeasurement, NewerOfSamePiece, RecalculationOf, RecalculatedBy, FirstArticle,
        NotToCut,
        VerifiedWithin, VerifiedOutside, NotCompared,
        NotComparable, PartRecorded, Approved,
        PieceCut, SlotUsable, LookedAtBase, TriedToRead, SlotEmpty, SlotHeld, CellStopped, HeldAfterCut, ReadBack, GivenBack, MachineWrote,
        EitherProgram, ChangedBefore, OfOtherCell, ChangedMeanwhile, NamedOtherwise, NamedOtherwiseThere, NameOfSlot, NameOfJob, NameOfFile,
        ChangedTwice, ChangedWhileHeld, HeldAgain, AnswersAgain,
        ReadBackUnseen, MachineBusy, MachineBusyUnnamed, MachineUnknown, WaitsTooLong, BacklogGrows, PieceWaits, StartedMeanwhile,
        StateAway, StateSlow, StateWrong, StateStale, StateUnavailable,
        UnknownPiece, AskedNobody, AskedWants, LikeAll, LikeName, LikeField, LikeColumn,
        AmbiguousPiece, ContradictoryPiece, SaysNoName, SaysTwo, UnusableJob, UnreadableInside, TooLarge, AlreadyKnown,
        SumsUnknown,
        PartOfNumberUnmeasured, NamedBoth, NamedSerial, NamedOrder, PartUnmeasured, NotReleasedReverted, NotReleased, BaseReverted,
        NotFeedback,
        NotFeedbackSurface, JobChanged, OriginalChanged, OverLimit, OverSumLimit, AtPlace, AndMore, Defect, FirstAdministrator, SignedIn,
        SignedInByPin, SignedInByBadge, SignedInByBadgeAndPin, WrongPin, NoSuchBadge, CredentialTampered, CredentialDiffers,
        AsRole, ToRole, UntilUtc,
        WrongPassword, WrongDisabled, NoSuchName, NoSuchNames, ByHand, Idle, StoreMade, FromBackup, StoredAside, SetBack, WitnessBegun,
        JobFiles, JobFile, JobInPlace, Program, File,
        RowsCoded, CorrectionTampered, SlotTampered, UserTampered, UserOfNoRole, NotSent, NoCorrection, NeverArrived, StepNotAllowed,
        ApprovalNotAllowed, NotByPolicy, WasNobody, WasDisabled, WasOfRole, OtherProgram, UserNotAllowed, UserUnknown,
        CorrectionUnrecorded, StateDiffers, ProgramDiffers, FileDiffers, CorrectionDiffers, CorrectionMissing, SlotHeldByOther,
        SlotNotHeld, SlotDiffers, UserUnrecorded, RoleDiffers, DisabledDiffers, UserDiffers, UserMissing, RowMissing, RowUnreadable,
        ContentDiffers, ContentMissing, StepDiffers, StepUnrecorded, FormDiffers, FormUnknown, FormLacks, FormOther, TrailBroken,
        Correction, Slot, BackupBroughtBack, Started, PoliciesOfCell, PoliciesOfJob, Stopped,
        .. RecordedAlarm.All, .. RecordedOffset.All, .. RecordedThinning.All, .. RecordedCheckpoint.All,
    ];

    private static readonly FrozenDictionary<string, SentenceForm> Known =
        All.Concat(WarningForms.All)
            .Concat(SurfaceWarningForms.All)
            .Concat(RefusalForms.All)
            .ToFrozenDictionary(f => f.Name, StringComparer.Ordinal);

    /// <summary>Reads a text of the store. What earlier versions wrote in English is words.</summary>
    internal static Statement Read(string text) => Statement.Read(text, Known);
}

/// <summary>The forms of what people did about alarms.</summary>
public static class RecordedAlarm
{
    /// <summary>The subject of such an entry: the alarm's key.</summary>
    public static SentenceForm Subject { get; } = new("alarm", "alarm \"{0}\"");

    /// <summary>The basis of acknowledging: since when the alarm lasted.</summary>
    public static SentenceForm SinceUtc { get; } = new("alarm-since", "it had lasted since {0:yyyy-MM-dd HH:mm:ss} UTC");

    /// <summary>The basis of acknowledging an alarm that does not say since when it lasted.</summary>
    public static SentenceForm SinceUnknown { get; } = new("alarm-since-unknown", "since when it had lasted is not known");

    /// <summary>The basis of shelving: until when.</summary>
    public static SentenceForm UntilUtc { get; } = new("alarm-until", "until {0:yyyy-MM-dd HH:mm:ss} UTC");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [Subject, SinceUtc, SinceUnknown, UntilUtc];
}

/// <summary>The forms of what the cell states about archives.</summary>
public static class RecordedThinning
{
    /// <summary>The word of the audit trail's entries about an archive.</summary>
    internal const string Thinned = "thinned";

    /// <summary>The subject of such an entry: the archive's name.</summary>
    public static SentenceForm Archive { get; } = new("archive", "archive {0}");

    /// <summary>What was moved: number of contents, stored bytes, SHA-256 of the archive, the date of the policy, and how many corrections
    /// of each slot stay.</summary>
    public static SentenceForm Moved { get; } = new(
        "contents-moved",
        "{0:0} contents with {1:0} bytes were moved there; SHA-256 of the file {2}. They belong to corrections from before "
            + "{3:yyyy-MM-dd} that are not among the last {4:0} of their slots, and that nothing needs any more.");

    internal static readonly SentenceForm Unrecorded = new(
        "archive-unrecorded",
        "Content {0} is said to be in the archive {1}, and no entry of the audit trail says that it was moved there.");

    internal static readonly SentenceForm Lacks = new("archive-lacks", "Content {0} is not in the archive {1} as it was kept.");

    internal static readonly SentenceForm Unusable = new("archive-unusable", "The archive {0} cannot be used: {1}");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [Archive, Moved, Unrecorded, Lacks, Unusable];
}

/// <summary>The forms of why a cell reads its whole audit trail instead of going on from a checkpoint.</summary>
internal static class RecordedCheckpoint
{
    /// <summary>There is no checkpoint.</summary>
    internal static readonly SentenceForm Missing = new(
        "checkpoint-missing", "The store has no checkpoint of its audit trail: all of the trail is read before the first program is sent.");

    /// <summary>It was made by other code, which may judge entries differently.</summary>
    internal static readonly SentenceForm OfOtherBuild = new(
        "checkpoint-of-other-build",
        "Another build of the program made the checkpoint of the audit trail: all of the trail is read before the first program is sent.");

    /// <summary>Somebody without the key wrote it: the number of its entry.</summary>
    internal static readonly SentenceForm Foreign = new(
        "checkpoint-foreign",
        "The checkpoint of the audit trail, at entry {0:0}, is not what the cell wrote there: somebody else wrote to the store. It is not "
            + "used, and all of the trail is read.");

    /// <summary>It belongs to another trail, or the store was set back: the number of its entry.</summary>
    internal static readonly SentenceForm Astray = new(
        "checkpoint-astray",
        "The checkpoint of the audit trail is of entry {0:0}, and that entry is missing or another one. It is not used, and all of the "
            + "trail is read.");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [Missing, OfOtherBuild, Foreign, Astray];
}
